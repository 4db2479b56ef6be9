// Cluster trees of made-up towns.
#pragma once

#include <memory>

#include "algorithms/merging/merging.h"
#include "algorithms/synthesis/synthesis.h"
#include "tests/support/plain_dendrogram.h"

namespace lodestone::test {

inline std::shared_ptr<const ClusterTree> treeOf(const CityModel& city) {
  const auto footprints = std::make_shared<const FootprintTable>(footprintTable(city));
  const auto dendrogram = std::make_shared<const Dendrogram>(plainDendrogram(*footprints, 3));
  return std::make_shared<const ClusterTree>(makeClusterTree(footprints, dendrogram));
}

inline std::shared_ptr<const ClusterTree> townTree(int buildings = 0, int seed = 5) {
  return treeOf(synthesiseCity({CityPreset::Town, buildings, seed}));
}

}  // namespace lodestone::test
