#include "algorithms/clustering/box_tree.h"

#include <algorithm>

#include "algorithms/clustering/packed_footprints.h"

namespace lodestone {
namespace {

std::vector<Box2> grouped(std::span<const Box2> boxes) {
  std::vector<Box2> groups((boxes.size() + BoxTree::kFan - 1) / BoxTree::kFan);
  for (std::size_t i = 0; i < boxes.size(); ++i) groups[i / BoxTree::kFan].add(boxes[i]);
  return groups;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box2> boxes) {
  levels_.push_back(grouped(boxes));
  while (levels_.back().size() > 1) levels_.push_back(grouped(levels_.back()));
}

void BoxTree::within(const Box2& box, double bound, std::vector<Hit>& hits) const {
  hits.clear();
  if (!levels_.back().empty()) visit(levels_.size() - 1, 0, box, bound, hits);
}

void BoxTree::visit(std::size_t level, std::uint32_t node, const Box2& box, double bound,
                    std::vector<Hit>& hits) const {
  const double squared = squaredDistance(levels_[level][node], box);
  if (squared > bound) return;
  if (level == 0) {
    hits.push_back({squared, node});
    return;
  }
  const std::uint32_t end =
      std::min((node + 1) * kFan, static_cast<std::uint32_t>(levels_[level - 1].size()));
  for (std::uint32_t child = node * kFan; child < end; ++child) visit(level - 1, child, box, bound, hits);
}

}  // namespace lodestone
