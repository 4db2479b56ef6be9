// The k nearest buildings of each building.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/clustering/footprint_distance.h"
#include "algorithms/clustering/links.h"
#include "algorithms/clustering/packed_footprints.h"

namespace lodestone {

/// For each slot its min(k, n − 1) nearest others, nearest first; of equally near ones (squared distances
/// equal in double precision) the one with the smaller building number is nearer.
struct NearestBuildings {
  struct Farthest {
    double squared = -1;
    std::uint32_t building = 0;
  };

  std::vector<LinkList> lists;     ///< by slot: other slots, and *squared* distances in square metres
  std::vector<Farthest> farthest;  ///< by slot: the last of its list

  /// Whether the list of a slot names a building at that distance from it: a look at the farthest tells.
  [[nodiscard]] bool names(std::uint32_t of, double squared, std::uint32_t building) const {
    const Farthest& last = farthest[of];
    return squared != last.squared ? squared < last.squared : building <= last.building;
  }
};

/// Cost: about O(n (k + log n)) for buildings spread like a city; parallel. Incomplete when a stop was
/// requested.
[[nodiscard]] NearestBuildings nearestBuildings(const PackedFootprints& packed, const FootprintTable& table,
                                                FootprintDistance distance, std::uint32_t k,
                                                const Progress& progress = {});

}  // namespace lodestone
