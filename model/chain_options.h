// Options of LOD chains (resources/docs/methods.md, section 6).
#pragma once

#include <string>

#include "model/cluster_options.h"

namespace lodestone {

struct ChainOptions {
  std::string tolerances =
      "5,10,20,40";         ///< metres of negative space of each level after the original, rising
  CutOptions cut;           ///< for switch distances and landmarks
  double fov = 45;          ///< vertical, degrees, for switch distances
  int pictureHeight = 800;  ///< pixels, for switch distances
  bool operator==(const ChainOptions&) const = default;
};

template <>
const std::vector<Field<ChainOptions>>& fields<ChainOptions>();

}  // namespace lodestone
