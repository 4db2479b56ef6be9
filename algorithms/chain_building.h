// LOD chains: the original and cuts of the cluster tree (resources/docs/methods.md, section 6).
#pragma once

#include "model/artifacts.h"
#include "model/progress.h"
#include "model/result.h"

namespace lodestone {

struct ChainOptions {
  std::string tolerances =
      "5,10,20,40";         ///< metres of negative space of each level after the original, rising
  double epsilon = 100;     ///< pixels, for switch distances and landmarks
  double alpha = 2;         ///< pixels
  double fov = 45;          ///< vertical, degrees, for switch distances
  int pictureHeight = 800;  ///< pixels, for switch distances
  bool operator==(const ChainOptions&) const = default;
};
template <>
const std::vector<Field<ChainOptions>>& fields<ChainOptions>();

/// Level 0 is the city itself (finest LoD of each building, or its footprint as a block); each tolerance adds
/// a level cut from the tree. `tree` may be null: then there is level 0 alone. Objects are made when asked
/// for.
[[nodiscard]] Result<LodChain> makeChain(std::shared_ptr<const CityModel> city,
                                         std::shared_ptr<const ClusterTree> tree, const ChainOptions& options,
                                         const Progress& progress = {}, const ArtifactSink& sink = {});

/// The level that one camera's cut draws: what the workbench shows is what it exports.
[[nodiscard]] LodLevel levelOfCut(std::shared_ptr<const CityModel> city,
                                  std::shared_ptr<const ClusterTree> tree, const Cut& cut);

}  // namespace lodestone
