#include "gui/workspace/same_clusters.h"

#include <algorithm>

namespace lodestone {
namespace {

std::vector<NodeId> leavesBelow(const ClusterTree& tree, NodeId root) {
  std::vector<NodeId> leaves;
  std::vector<NodeId> open{root};
  while (!open.empty()) {
    const NodeId node = open.back();
    open.pop_back();
    if (tree.isLeaf(node)) {
      leaves.push_back(node);
    } else {
      open.insert(open.end(), {tree.nodes[node].a, tree.nodes[node].b});
    }
  }
  std::sort(leaves.begin(), leaves.end());
  return leaves;
}

/// Any leaf, by at most log2(size) steps.
NodeId leafBelow(const ClusterTree& tree, NodeId node) {
  while (!tree.isLeaf(node)) {
    const NodeId a = tree.nodes[node].a;
    const NodeId b = tree.nodes[node].b;
    node = tree.nodes[a].size < tree.nodes[b].size ? a : b;
  }
  return node;
}

/// The node of `after` with exactly the leaves of a node of `before`, or kNoNode: one of the ancestors of any
/// of them. Leaves are listed only where their number is the same.
NodeId nodeOf(const ClusterTree& after, const ClusterTree& before, NodeId wanted) {
  const std::uint32_t size = before.nodes[wanted].size;
  NodeId node = leafBelow(before, wanted);
  while (node != kNoNode && after.nodes[node].size < size) node = after.nodes[node].parent;
  if (node == kNoNode || after.nodes[node].size != size) return kNoNode;
  return leavesBelow(after, node) == leavesBelow(before, wanted) ? node : kNoNode;
}

}  // namespace

std::vector<NodeId> sameClusters(const ClusterTree* before, const ClusterTree* after,
                                 const std::vector<NodeId>& nodes) {
  std::vector<NodeId> result;
  for (const NodeId node : nodes) {
    if (!before || before->isLeaf(node)) {
      result.push_back(node);  // building i is node i of every tree
    } else if (after) {
      const NodeId same = nodeOf(*after, *before, node);
      if (same != kNoNode) result.push_back(same);
    }
  }
  return result;
}

}  // namespace lodestone
