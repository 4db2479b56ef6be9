#include "algorithms/geometry/box_pairs.h"

#include <algorithm>

#include "algorithms/geometry/triangle_tree.h"

namespace lodestone {

std::vector<std::pair<std::uint32_t, std::uint32_t>> meetingPairs(std::span<const Box3> boxes) {
  Box3 centres;
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].empty()) continue;
    centres.add(boxes[i].center());
    order.push_back(i);
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  if (order.size() < 2) return pairs;
  int axis = 0;
  centres.size().maxCoeff(&axis);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double at = boxes[a].min[axis];
    const double bt = boxes[b].min[axis];
    return at != bt ? at < bt : a < b;
  });
  std::vector<std::uint32_t> open;  // boxes that the sweep has entered and not left
  for (const std::uint32_t box : order) {
    std::erase_if(open, [&](std::uint32_t other) { return boxes[other].max[axis] < boxes[box].min[axis]; });
    for (const std::uint32_t other : open) {
      if (meet(boxes[box], boxes[other])) pairs.emplace_back(std::min(box, other), std::max(box, other));
    }
    open.push_back(box);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace lodestone
