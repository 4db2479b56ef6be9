// The k nearest buildings of each building.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/footprint_distance.h"
#include "algorithms/packed_footprints.h"

namespace lodestone {

/// One near building: squared distance in square metres, and its slot.
struct Neighbour {
  double squared = 0;
  std::uint32_t slot = 0;
};

/// For each slot its min(k, n − 1) nearest others, nearest first; of equally near ones (squared distances
/// equal in double precision) the one with the smaller building number is nearer.
struct NearestBuildings {
  std::uint32_t perSlot = 0;
  std::vector<double> squared;      ///< perSlot values a slot
  std::vector<std::uint32_t> slot;  ///< perSlot values a slot

  [[nodiscard]] Neighbour at(std::uint32_t of, std::uint32_t rank) const {
    const std::size_t i = static_cast<std::size_t>(of) * perSlot + rank;
    return {squared[i], slot[i]};
  }
};

/// Cost: about O(n (k + log n)) for buildings spread like a city; parallel. Incomplete when a stop was
/// requested.
[[nodiscard]] NearestBuildings nearestBuildings(const PackedFootprints& packed, const FootprintTable& table,
                                                FootprintDistance distance, std::uint32_t k,
                                                const Progress& progress = {});

}  // namespace lodestone
