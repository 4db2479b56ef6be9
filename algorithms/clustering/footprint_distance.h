// How far two footprints are apart.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "model/cluster_options.h"
#include "model/footprint_table.h"

namespace lodestone {

/// The closest points of two footprints.
struct ClosestPoints {
  double squared = std::numeric_limits<double>::infinity();  ///< squared distance, square metres
  Vec2 onFirst = Vec2::Zero();                               ///< on the footprint with the smaller number
  Vec2 onSecond = Vec2::Zero();
};

/// Closest points of footprints a and b (any order gives the same, bit for bit).
/// Vertex: the closest vertices, those of holes included (Chang et al. 2008, section 5); of equally close
/// pairs the first in the order of the table. Outline: the closest points of the outlines, holes included;
/// distance 0 where the footprints cross, touch or lie in each other, but not where one stands in the other's
/// courtyard. Outlines that touch only at rounded coordinates come out as close as the rounding, not as 0.
/// Pairs further apart than √limit may be left unmeasured: then `squared` is above limit.
/// Cost: vertices of a × vertices of b.
[[nodiscard]] ClosestPoints closestPoints(const FootprintTable& footprints, std::uint32_t a, std::uint32_t b,
                                          FootprintDistance distance,
                                          double limit = std::numeric_limits<double>::infinity());

/// Metres between the closest points of two rings; 0 where they cross, touch or lie in each other, and where
/// one of them is empty.
[[nodiscard]] double gapBetween(std::span<const Vec2> a, std::span<const Vec2> b);

}  // namespace lodestone
