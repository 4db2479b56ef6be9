// Which nodes are drawn from a camera (Chang et al. 2008, section 7; resources/docs/methods.md 1.4).
#pragma once

#include "model/cluster_tree.h"

namespace lodestone {

/// Descends the tree: culls by frustum, draws a cluster when its negative space covers at most ε pixels, and
/// the buildings that stand out of it by more than α pixels as landmarks. Order: depth first, child a before
/// child b. Cost: about 2 ms for 370,000 buildings.
[[nodiscard]] Cut makeCut(const ClusterTree& tree, const CutOptions& options, const Camera& camera);

/// Side of the square, in metres, that covers as much as the negative space of a node does: seen from above,
/// where it is `negative`, or from the side, where it is a wall across `gap` as high as the node. Thin hulls
/// between buildings far apart have next to no area, and are seen all the same. 0 for buildings.
[[nodiscard]] double emptiness(const ClusterNode& node);

/// A cut that does not depend on a camera. Clusters that may be drawn have an error of at most `tolerance`
/// metres, where the error of a node is its emptiness(), never less than a child's. Of all cuts of such
/// clusters and of buildings it is the one with the fewest polygons, landmarks included, and of equal ones
/// the coarser: a cluster is not drawn where what it stands for is lighter, as where most of its buildings
/// are landmarks. So polygons never rise with the tolerance, and never above those of all buildings.
/// Landmarks stand out by more than tolerance · α / √ε metres, which is what α means at the distance from
/// which ε pixels are that tolerance. Cost: about n log n.
[[nodiscard]] Cut makeUniformCut(const ClusterTree& tree, const CutOptions& options, double tolerance);

/// Metres from which a negative space of tolerance² square metres covers at most ε pixels of a picture of
/// `height` pixels and `fov` degrees.
[[nodiscard]] double switchDistance(double tolerance, double epsilon, double fov, int height);

/// The box that stands for a cluster's negative space (placed towards the eye), local metres.
[[nodiscard]] Box3 negativeSpaceBox(const ClusterTree& tree, NodeId node, const Vec3& eye);

/// The cut at a height of the dendrogram: all nodes whose parent's weight is above `weight` and their own is
/// not. Cost: linear in the tree, without following it, where merges rise in weight (every linkage but
/// k-means).
[[nodiscard]] std::vector<NodeId> nodesAtWeight(const ClusterTree& tree, double weight);

}  // namespace lodestone
