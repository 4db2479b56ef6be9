// Cluster trees of made-up towns.
#pragma once

#include <memory>

#include "algorithms/merging/merging.h"
#include "algorithms/synthesis/synthesis.h"
#include "tests/support/plain_dendrogram.h"

namespace lodestone::test {

inline std::shared_ptr<const ClusterTree> townTree(int buildings = 0, int seed = 5) {
  const auto footprints = std::make_shared<const FootprintTable>(
      footprintTable(synthesiseCity({CityPreset::Town, buildings, seed})));
  const auto dendrogram = std::make_shared<const Dendrogram>(plainDendrogram(*footprints, 3));
  return std::make_shared<const ClusterTree>(makeClusterTree(footprints, dendrogram));
}

}  // namespace lodestone::test
