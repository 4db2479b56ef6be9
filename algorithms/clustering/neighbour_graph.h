// Which buildings are looked at together (Chang et al. 2008, section 5).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/clustering/clustering.h"
#include "algorithms/clustering/links.h"
#include "algorithms/clustering/packed_footprints.h"

namespace lodestone {

/// An undirected graph; each edge stands in the lists of both its ends. Lists are sorted: permitted before
/// forbidden, then by distance.
struct NeighbourGraph {
  std::vector<LinkList> lists;  ///< by node

  [[nodiscard]] std::uint32_t nodeCount() const { return static_cast<std::uint32_t>(lists.size()); }
  [[nodiscard]] std::span<Link> linksOf(std::uint32_t node) const { return lists[node].span(); }
};

/// The k nearest buildings of each building, made symmetric, and the pairs that the minimum spanning tree of
/// all ground vertices joins: connected whatever k is. Nodes are slots of `packed`. Edges carry d, changed by
/// the context: the attribute term is added, then a pair whose closest segment crosses a barrier costs
/// barrierFactor times as much, or is forbidden where that is 0. Which pairs are neighbours depends on d
/// alone. Cost: O(n (k + log n)) time, some 15·k·n bytes. Incomplete when a stop was requested.
[[nodiscard]] NeighbourGraph neighbourGraph(const PackedFootprints& packed, const FootprintTable& footprints,
                                            const ClusterOptions& options, const ClusterContext& context,
                                            const Progress& progress = {});

}  // namespace lodestone
