#include "algorithms/merging/lightest_cut.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace lodestone {
namespace {

/// Sums over [0, n) of values that are added one by one (Fenwick 1994).
class PartialSums {
 public:
  explicit PartialSums(std::size_t count) : sums_(count + 1, 0) {}
  void add(std::size_t place, std::uint64_t value) {
    for (++place; place < sums_.size(); place += place & (~place + 1)) sums_[place] += value;
  }
  [[nodiscard]] std::uint64_t before(std::size_t place) const {
    std::uint64_t sum = 0;
    for (; place > 0; place -= place & (~place + 1)) sum += sums_[place];
    return sum;
  }

 private:
  std::vector<std::uint64_t> sums_;
};

/// Clusters that have landmarks, and the height from which on their buildings are any; highest first.
std::vector<std::pair<double, NodeId>> limitsOf(const ClusterTree& tree, const std::vector<bool>& drawn,
                                                double alphaHeight) {
  std::vector<std::pair<double, NodeId>> limits;
  for (NodeId id = 0; id < tree.nodes.size(); ++id) {
    const ClusterNode& node = tree.nodes[id];
    const double limit = node.base + node.height + alphaHeight;
    if (!tree.isLeaf(id) && drawn[id] && node.maxTop > limit) limits.emplace_back(limit, id);
  }
  std::sort(limits.rbegin(), limits.rend());
  return limits;
}

/// Polygons of the landmarks of every drawn cluster. A cluster's buildings are a stretch of the leaf order.
/// Clusters are asked from the highest limit down, while buildings join the sums from the tallest down.
std::vector<std::uint64_t> landmarkPolygons(const ClusterTree& tree, const std::vector<bool>& drawn,
                                            double alphaHeight) {
  std::vector<std::uint64_t> polygons(tree.nodes.size(), 0);
  const auto limits = limitsOf(tree, drawn, alphaHeight);
  if (limits.empty()) return polygons;
  const LeafOrder order = leafOrder(*tree.dendrogram);
  const auto at = [&](std::uint32_t place) -> const ClusterNode& { return tree.nodes[order.leaves[place]]; };
  std::vector<std::uint32_t> tallest(order.leaves.size());
  std::iota(tallest.begin(), tallest.end(), 0U);
  std::sort(tallest.begin(), tallest.end(),
            [&](std::uint32_t p, std::uint32_t q) { return at(p).maxTop > at(q).maxTop; });
  PartialSums sums(order.leaves.size());
  std::size_t joined = 0;
  for (const auto& [limit, id] : limits) {
    for (; joined < tallest.size() && at(tallest[joined]).maxTop > limit; ++joined)
      sums.add(tallest[joined], at(tallest[joined]).faces.polygons);
    polygons[id] = sums.before(order.first[id] + order.count[id]) - sums.before(order.first[id]);
  }
  return polygons;
}

}  // namespace

std::vector<bool> lightestNodes(const ClusterTree& tree, const std::function<bool(NodeId)>& allowed,
                                double alphaHeight) {
  std::vector<bool> drawn(tree.nodes.size());
  for (NodeId id = 0; id < tree.nodes.size(); ++id) drawn[id] = tree.isLeaf(id) || allowed(id);
  const std::vector<std::uint64_t> landmarks = landmarkPolygons(tree, drawn, alphaHeight);
  std::vector<std::uint64_t> lightest(tree.nodes.size());  // polygons of the best cut below each node
  for (NodeId id = 0; id < tree.nodes.size(); ++id) {      // children come before their parents
    const ClusterNode& node = tree.nodes[id];
    lightest[id] = node.faces.polygons + landmarks[id];
    if (tree.isLeaf(id)) continue;
    const std::uint64_t apart = lightest[node.a] + lightest[node.b];
    drawn[id] = drawn[id] && lightest[id] <= apart;
    if (!drawn[id]) lightest[id] = apart;
  }
  return drawn;
}

}  // namespace lodestone
