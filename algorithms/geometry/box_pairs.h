// Pairs of boxes that meet.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

/// All pairs (a, b), a < b, of closed boxes with a common point, ascending. Empty boxes meet nothing. A sweep
/// along the axis on which the boxes spread most. Cost: O(n log n + pairs that overlap on that axis).
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> meetingPairs(std::span<const Box3> boxes);

}  // namespace lodestone
