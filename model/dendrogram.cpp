#include "model/dendrogram.h"

#include <algorithm>

namespace lodestone {

std::vector<NodeId> parents(const Dendrogram& dendrogram) {
  std::vector<NodeId> result(dendrogram.nodeCount(), kNoNode);
  NodeId node = dendrogram.leafCount;
  for (const Merge& merge : dendrogram.merges) {
    result[merge.a] = node;
    result[merge.b] = node;
    ++node;
  }
  return result;
}

std::uint32_t depthOf(const Dendrogram& dendrogram) {
  std::vector<std::uint32_t> depth(dendrogram.nodeCount(), 0);
  NodeId node = dendrogram.leafCount;
  for (const Merge& merge : dendrogram.merges) depth[node++] = std::max(depth[merge.a], depth[merge.b]) + 1;
  return depth.empty() ? 0 : depth.back();
}

LeafOrder leafOrder(const Dendrogram& dendrogram) {
  LeafOrder order;
  const NodeId nodes = dendrogram.nodeCount();
  order.count.assign(nodes, 1);
  order.first.assign(nodes, 0);
  for (NodeId node = dendrogram.leafCount; node < nodes; ++node) {
    order.count[node] = order.count[dendrogram.merge(node).a] + order.count[dendrogram.merge(node).b];
  }
  const std::vector<NodeId> parent = parents(dendrogram);
  std::uint32_t next = 0;  // roots of a forest follow one another
  order.leaves.resize(dendrogram.leafCount);
  for (NodeId node = nodes; node-- > 0;) {
    if (parent[node] == kNoNode) {
      order.first[node] = next;
      next += order.count[node];
    }
    if (dendrogram.isLeaf(node)) {
      order.leaves[order.first[node]] = node;
    } else {
      const Merge& merge = dendrogram.merge(node);
      order.first[merge.a] = order.first[node];
      order.first[merge.b] = order.first[node] + order.count[merge.a];
    }
  }
  return order;
}

}  // namespace lodestone
