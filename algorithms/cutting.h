// Which nodes are drawn from a camera (Chang et al. 2008, section 7; resources/docs/methods.md 1.4).
#pragma once

#include "model/cluster_tree.h"

namespace lodestone {

/// Descends the tree: culls by frustum, draws a cluster when its negative space covers at most ε pixels, and
/// the buildings that stand out of it by more than α pixels as landmarks. Order: depth first, child a before
/// child b. Cost: about 2 ms for 370,000 buildings.
[[nodiscard]] Cut makeCut(const ClusterTree& tree, const CutOptions& options, const Camera& camera);

/// A cut that does not depend on a camera: clusters whose error is at most `tolerance` metres, where the
/// error of a node is the side of the square of its negative space, never less than a child's. Landmarks
/// stand out by more than tolerance · α / √ε metres, which is what α means at the distance from which ε
/// pixels are that tolerance.
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
