#include "model/import_options.h"

namespace lodestone {

template <>
const std::vector<Field<ImportOptions>>& fields<ImportOptions>() {
  using O = ImportOptions;
  static const std::vector<Field<O>> table{
      text(&O::height, "height", "Height",
           "Field that holds building heights in metres, or one number for all. Empty: the usual fields "
           "(height, "
           "HEIGHT_ROOF, measuredHeight, building:height …)."),
      text(&O::floors, "floors", "Floors",
           "Field that holds the number of floors. Empty: the usual fields (building:levels …)."),
      real(&O::floorHeight, "floor-height", "Floor height", "m", 0.5, 20, "Height of one floor."),
      real(&O::defaultHeight, "default-height", "Default height", "m", 0.1, 1000,
           "Height of buildings for which the input says nothing."),
      text(&O::layer, "layer", "Layer",
           "Layer of a file that has several; info lists them. Empty: the first of polygons whose name "
           "speaks of "
           "buildings, else the first of polygons; OSM: its buildings."),
      text(&O::crs, "crs", "Coordinate system", "EPSG:N, taken instead of what the file says."),
      choice(&O::upAxis, "up-axis", "Up axis", {"auto", "y", "z"},
             "Which axis of a mesh points up; auto: what the format or the file says."),
      real(&O::unit, "unit", "Unit", "m", 1e-6, 1e6, "Metres in one unit of a mesh: 0.001 for millimetres."),
      flag(&O::allowOutside, "allow-outside", "Allow outside paths",
           "Follow texture paths that lead out of the input's folder."),
  };
  return table;
}

}  // namespace lodestone
