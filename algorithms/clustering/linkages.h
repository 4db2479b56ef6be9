// The linkages that stand beside the legible one, for comparison (Chang et al. 2008, section 5 and figure 5).
#pragma once

#include <vector>

#include "algorithms/clustering/agglomeration.h"
#include "algorithms/clustering/clustering.h"
#include "algorithms/clustering/packed_footprints.h"

namespace lodestone {

/// Plain single-link on the neighbour graph: w = d, with the ties of the legible linkage. Kruskal's
/// algorithm; edges of one length are agglomerated together, so that rows of touching houses make flat trees
/// here too. Cost: O(E log E) at worst; long edges inside clusters are never sorted. Incomplete when a stop
/// was requested.
[[nodiscard]] std::vector<Join> singleLink(const NeighbourGraph& graph, Clusters leaves,
                                           const Progress& progress = {});

/// Most buildings that complete-link takes: it keeps the distances of all pairs, 8 bytes each.
inline constexpr std::uint32_t kCompleteLinkLimit = 10000;

/// Complete-link over all pairs of buildings, not the neighbour graph, which knows near pairs alone: w = d =
/// the greatest distance of any two buildings of the clusters; a forbidden pair makes its clusters' pair
/// forbidden. Nearest-neighbour chain. \throw std::length_error above kCompleteLinkLimit buildings. Cost:
/// O(n²) time and memory. Incomplete when a stop was requested.
[[nodiscard]] std::vector<Join> completeLink(const PackedFootprints& packed, const FootprintTable& footprints,
                                             const ClusterOptions& options, const ClusterContext& context,
                                             const Progress& progress = {});

/// Bisecting k-means on the centres of the buildings' boxes, as a tree: each cluster is divided by 2-means,
/// started from the building furthest from its mean and the one furthest from that. Barriers and attributes
/// do not enter. w is the cluster's sum of squared distances to its mean (m²), d the distance of the two
/// parts' means. Cost: about O(n log n) per iteration, at most 100. Incomplete when a stop was requested.
[[nodiscard]] std::vector<Join> bisectingKMeans(const PackedFootprints& packed,
                                                const Progress& progress = {});

}  // namespace lodestone
