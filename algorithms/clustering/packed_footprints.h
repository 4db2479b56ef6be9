// Footprints laid out for searching.
#pragma once

#include <cstdint>
#include <vector>

#include "model/footprint_table.h"
#include "model/progress.h"

namespace lodestone {

/// The buildings that have a footprint, in the order of a Hilbert curve through the centres of their boxes,
/// so that near buildings are near in memory. A building's place in this order is its slot. Coordinates are
/// those of the table, unchanged: distances taken here equal distances taken there to the last bit.
struct PackedFootprints {
  std::vector<std::uint32_t> building;        ///< by slot: its number in the footprint table
  std::vector<std::uint32_t> vertexStart{0};  ///< by slot, and one past the last
  std::vector<double> x;                      ///< of all vertices of all rings, slot after slot
  std::vector<double> y;
  std::vector<Box2> box;  ///< by slot

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(building.size()); }
};

/// Incomplete when a stop was requested.
[[nodiscard]] PackedFootprints packFootprints(const FootprintTable& footprints,
                                              const Progress& progress = {});

/// Squared distance of two boxes; 0 where they meet. Never above the squared distance of any two points in
/// them, in floating point either, since rounding is monotone.
[[nodiscard]] inline double squaredDistance(const Box2& a, const Box2& b) {
  const double dx = std::max(0.0, std::max(a.min.x() - b.max.x(), b.min.x() - a.max.x()));
  const double dy = std::max(0.0, std::max(a.min.y() - b.max.y(), b.min.y() - a.max.y()));
  return dx * dx + dy * dy;
}

}  // namespace lodestone
