#include "gui/view3d/marks.h"

namespace lodestone {

Marks::Marks(const LeafOrder& leaves, std::span<const NodeId> nodes) : leaves_(&leaves) {
  if (nodes.empty()) return;
  // Ends of the marked ranges, summed up to how many ranges lie over each place.
  std::vector<std::int64_t> ends(leaves.leaves.size() + 1, 0);
  for (const NodeId node : nodes) {
    if (node >= leaves.first.size()) continue;
    ++ends[leaves.first[node]];
    --ends[leaves.first[node] + leaves.count[node]];
  }
  before_.assign(leaves.leaves.size() + 1, 0);
  std::int64_t over = 0;
  for (std::size_t i = 0; i < leaves.leaves.size(); ++i) {
    over += ends[i];
    before_[i + 1] = before_[i] + (over > 0 ? 1 : 0);
  }
}

Mark Marks::of(NodeId node) const {
  if (before_.empty() || node >= leaves_->first.size()) return Mark::None;
  const std::uint32_t first = leaves_->first[node];
  const std::uint32_t count = leaves_->count[node];
  const std::uint32_t marked = before_[first + count] - before_[first];
  if (marked == 0) return Mark::None;
  return marked == count ? Mark::Whole : Mark::Part;
}

}  // namespace lodestone
