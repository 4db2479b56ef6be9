// What an import may need to be told beside the file.
#pragma once

#include <string>

#include "model/options.h"

namespace lodestone {

enum class UpAxisOption { Auto, Y, Z };

struct ImportOptions {
  std::string height;  ///< field with heights in metres, or one number for all buildings; empty: usual fields
  std::string floors;  ///< field with the number of floors; empty: usual fields
  double floorHeight = 3;     ///< metres a floor
  double defaultHeight = 10;  ///< metres, where the input says nothing
  std::string layer;          ///< layer of a file with several; empty: as chosen by footprints.h
  std::string crs;            ///< "EPSG:N" instead of what the file says
  bool allowOutside = false;  ///< follow texture paths that leave the input's folder
  UpAxisOption upAxis = UpAxisOption::Auto;  ///< of meshes; auto: what the format or the file says
  double unit = 1;                           ///< metres in one unit of a mesh
  bool operator==(const ImportOptions&) const = default;
};

template <>
const std::vector<Field<ImportOptions>>& fields<ImportOptions>();

}  // namespace lodestone
