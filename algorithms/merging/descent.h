// The way down through a cluster tree.
#pragma once

#include <vector>

#include "model/cluster_tree.h"

namespace lodestone {

/// Nodes still to be looked at, depth first, child a before child b. Trees may be as deep as they have nodes.
class Descent {
 public:
  explicit Descent(const ClusterTree& tree) : tree_(tree) {}
  void start(NodeId node) { open_.assign(1, node); }
  /// Starts at the root. A tree without merges has none: then at its one building that has a footprint.
  void start() {
    open_.clear();
    if (tree_.nodes.empty()) return;
    const auto last = static_cast<NodeId>(tree_.nodes.size() - 1);
    if (!tree_.isLeaf(last)) return start(last);
    for (NodeId leaf = 0; leaf <= last; ++leaf) {
      if (tree_.nodes[leaf].edges > 0) open_.push_back(leaf);
    }
  }
  void openChildrenOf(NodeId node) {
    open_.push_back(tree_.nodes[node].b);
    open_.push_back(tree_.nodes[node].a);
  }
  [[nodiscard]] bool done() const { return open_.empty(); }
  NodeId next() {
    const NodeId node = open_.back();
    open_.pop_back();
    return node;
  }

 private:
  const ClusterTree& tree_;
  std::vector<NodeId> open_;
};

}  // namespace lodestone
