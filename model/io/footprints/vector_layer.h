// One layer of a vector data set as buildings.
#pragma once

#include <string>
#include <vector>

#include "model/city_model.h"
#include "model/io/footprints/footprint_heights.h"
#include "model/progress.h"
#include "model/result.h"

class OGRLayer;

namespace lodestone {

/// Where a layer comes from, as far as it matters here.
enum class LayerKind {
  Plain,
  GeoJson,  ///< feature numbers other than the index are ids of the source
  Osm,
};

/// What a layer gave, before heights and repairs.
struct LayerFeatures {
  std::vector<Building> buildings;  ///< footprints as they stand, or geometry where the source has walls
  std::vector<Vec2> zRange;       ///< of each building: lowest and highest z; NaN for plan outlines without z
  std::size_t otherGeometry = 0;  ///< features that are points or lines
  std::size_t withoutGeometry = 0;
  std::size_t withoutId = 0;
  std::size_t parts = 0;  ///< OSM: building:part without building
};

/// Reads all features, one by one. Ids: the feature's own, else a property id, gml_id or gml:id, else
/// `idPrefix` and the index. Of OSM, the areas tagged building (not "no"), with ids "way/N" and "relation/N"
/// and their tags as attributes. \throw Cancelled
[[nodiscard]] LayerFeatures readFeatures(OGRLayer& layer, LayerKind kind, const std::string& idPrefix,
                                         const Progress& progress);

/// OGR's hstore text ("a"=>"b","c"=>"d") as attributes.
[[nodiscard]] Attributes parseTags(std::string_view hstore);

}  // namespace lodestone
