// Merged hulls of all clusters (Chang et al. 2008, section 6; resources/docs/methods.md 1.3).
#pragma once

#include <memory>

#include "model/artifacts.h"
#include "model/cluster_tree.h"
#include "model/progress.h"

namespace lodestone {

/// A hull, an area of negative space and a height for every node of the dendrogram. In parallel, the same for
/// any number of threads. \pre the dendrogram is of these footprints. \throw Cancelled
[[nodiscard]] ClusterTree makeClusterTree(std::shared_ptr<const FootprintTable> footprints,
                                          std::shared_ptr<const Dendrogram> dendrogram,
                                          const MergeOptions& options = {}, const Progress& progress = {},
                                          const ArtifactSink& sink = {});

/// The merged hull of several rings that may touch, overlap or lie apart: convex hull, divided until
/// `targetEdges` edges are reached or no edge can be divided. Simple, counter-clockwise, contains all rings,
/// its vertices are theirs.
[[nodiscard]] Ring mergedHull(const std::vector<Ring>& children, std::size_t targetEdges);

}  // namespace lodestone
