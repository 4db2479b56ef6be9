// Areas of overlap between footprints.
#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

/// A side of a footprint, with the inside on its left, that belongs to one of two sets.
struct OverlapSide {
  Vec2 from;
  Vec2 to;
  std::uint8_t set = 0;
};

/// Area that both sets cover. Footprints of one set may overlap. The plane is cut into upright strips at all
/// ends and crossings; in each strip the sides stand in order. In doubles, relative error about 1e-12 of the
/// boxes' area. O(n²) for n sides.
[[nodiscard]] double overlapArea(const std::vector<OverlapSide>& sides);

}  // namespace lodestone
