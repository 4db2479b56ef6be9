// A selection that outlives the tree it was made in.
#pragma once

#include <vector>

#include "model/cluster_tree.h"

namespace lodestone {

/// The nodes of `after` that hold exactly the buildings of `nodes`, which are nodes of `before`, in their
/// order; what is no cluster there is left out. Either tree may be null: then its nodes are its buildings
/// alone. Both are trees of one city. Cost: O(buildings in `nodes` + depth of `after`).
[[nodiscard]] std::vector<NodeId> sameClusters(const ClusterTree* before, const ClusterTree* after,
                                               const std::vector<NodeId>& nodes);

}  // namespace lodestone
