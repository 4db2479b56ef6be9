// The hierarchy of a clustering.
#pragma once

#include <cstdint>
#include <vector>

#include "model/cluster_options.h"

namespace lodestone {

/// Node id: building i is node i; merge j is node leafCount + j.
using NodeId = std::uint32_t;
inline constexpr NodeId kNoNode = 0xFFFFFFFFU;

struct Merge {
  NodeId a = 0;  ///< the child with the smaller smallest leaf
  NodeId b = 0;
  /// d of the two clusters as the linkage saw it: metres; with an attribute term or barriers that plus the term,
  /// times the factor.
  double distance = 0;
  /// w of the linkage (legible: size(a)·size(b)·d). A join over an absolute barrier, made when nothing else is
  /// left, has the greatest weight so far: heights of the drawing must not fall where a barrier stands.
  double weight = 0;
  double cost = 0;  ///< Eq. (1): w / avgClusterSize²
  std::uint32_t size = 0;
  bool operator==(const Merge&) const = default;
};

/// Merges stand in the order of the greedy algorithm. n leaves with a footprint have n − 1 merges; a leaf without one is in
/// none.
struct Dendrogram {
  ClusterOptions options;
  std::uint32_t leafCount = 0;
  std::vector<Merge> merges;
  std::uint32_t depth = 0;  ///< edges from the root to the deepest leaf

  [[nodiscard]] std::uint32_t nodeCount() const {
    return leafCount + static_cast<std::uint32_t>(merges.size());
  }
  [[nodiscard]] bool isLeaf(NodeId node) const { return node < leafCount; }
  [[nodiscard]] const Merge& merge(NodeId node) const { return merges[node - leafCount]; }
  [[nodiscard]] NodeId root() const { return nodeCount() == 0 ? kNoNode : nodeCount() - 1; }
};

/// Parent of every node; kNoNode for the root.
[[nodiscard]] std::vector<NodeId> parents(const Dendrogram& dendrogram);
/// Edges between the root and its deepest leaf.
[[nodiscard]] std::uint32_t depthOf(const Dendrogram& dendrogram);
/// Leaves in the order in which a drawing without crossings shows them, and for each node the range of that
/// order which lies below it.
struct LeafOrder {
  std::vector<NodeId> leaves;
  std::vector<std::uint32_t> first;  ///< by node: position of its first leaf
  std::vector<std::uint32_t> count;  ///< by node
};
[[nodiscard]] LeafOrder leafOrder(const Dendrogram& dendrogram);

}  // namespace lodestone
