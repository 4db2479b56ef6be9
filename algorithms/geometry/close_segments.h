// Pairs of segments whose boxes meet, by a sweep over x.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

/// Calls `visit(i, j)` for every pair of segments whose boxes meet, until it returns false. `segment(i)`
/// gives the two ends. O(n log n + pairs whose x ranges meet).
template <class SegmentOf, class Visit>
void forCloseSegments(std::size_t count, const SegmentOf& segment, const Visit& visit) {
  std::vector<Box2> box(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b] = segment(i);
    box[i].add(a);
    box[i].add(b);
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return box[i].min.x() != box[j].min.x() ? box[i].min.x() < box[j].min.x() : i < j;
  });
  for (std::size_t k = 0; k < count; ++k) {
    const Box2& first = box[order[k]];
    for (std::size_t m = k + 1; m < count && box[order[m]].min.x() <= first.max.x(); ++m) {
      const Box2& second = box[order[m]];
      if (second.min.y() > first.max.y() || first.min.y() > second.max.y()) continue;
      if (!visit(order[k], order[m])) return;
    }
  }
}

}  // namespace lodestone
