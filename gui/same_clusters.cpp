#include "gui/same_clusters.h"

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

/// The node with exactly these leaves, or kNoNode: one of the ancestors of any of them.
NodeId nodeOf(const ClusterTree& tree, const std::vector<NodeId>& leaves) {
  NodeId node = leaves.front();
  while (node != kNoNode && tree.nodes[node].size < leaves.size()) node = tree.nodes[node].parent;
  return node != kNoNode && leavesBelow(tree, node) == leaves ? node : kNoNode;
}

}  // namespace

std::vector<NodeId> sameClusters(const ClusterTree* before, const ClusterTree* after,
                                 const std::vector<NodeId>& nodes) {
  std::vector<NodeId> result;
  for (const NodeId node : nodes) {
    if (!before || before->isLeaf(node)) {
      result.push_back(node);  // building i is node i of every tree
    } else if (after) {
      const NodeId same = nodeOf(*after, leavesBelow(*before, node));
      if (same != kNoNode) result.push_back(same);
    }
  }
  return result;
}

}  // namespace lodestone
