// The cut of a cluster tree that draws the fewest polygons.
#pragma once

#include <functional>

#include "model/cluster_tree.h"

namespace lodestone {

/// For each node whether to draw it when a descent from the root comes to it, so that what is drawn in the
/// end has the fewest polygons of all cuts of buildings and of clusters that are `allowed`; of equal ones the
/// coarser. A cluster counts with its landmarks: the buildings in it whose top stands out of its own by more
/// than `alphaHeight` metres. Cost: n log n, however deep the tree is.
[[nodiscard]] std::vector<bool> lightestNodes(const ClusterTree& tree,
                                              const std::function<bool(NodeId)>& allowed, double alphaHeight);

}  // namespace lodestone
