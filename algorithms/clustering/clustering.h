// Hierarchical clustering of buildings (Chang et al. 2008, section 5; resources/docs/methods.md 1.2).
#pragma once

#include "model/artifacts.h"
#include "model/cluster_options.h"
#include "model/dendrogram.h"
#include "model/footprint_table.h"
#include "model/progress.h"
#include "model/result.h"

namespace lodestone {

/// What clustering needs beside the footprints; both may be empty.
struct ClusterContext {
  std::vector<std::vector<Vec2>> barriers;  ///< lines not to be crossed
  std::vector<double> attribute;     ///< one number a building (NaN: missing); text attributes numbered
  double attributeWeight = 0;        ///< metres a unit
  bool attributeIsCategory = false;  ///< differs or not, instead of by how much
};

/// The context that `options` asks for, from a city model and barrier layers.
[[nodiscard]] Result<ClusterContext> clusterContext(const CityModel& model, const ClusterOptions& options,
                                                    const std::vector<LineLayer>& barriers);

/// The dendrogram of the buildings: that of the greedy algorithm on the neighbour graph, for any number of
/// threads.
///
/// A building without a footprint has no place: it is a leaf that no merge names, so that building i stays
/// node i. With m buildings that have one there are m − 1 merges. Distances include the attribute term and
/// the barrier factor. Where barriers are absolute (factor 0), pairs across them are joined only when no
/// other pair is left anywhere; the weight of such a merge is raised to the greatest before it, so that a cut
/// of the tree by weight crosses no barrier unless all else is joined.
///
/// \pre options passed check(). \throw Cancelled
/// Cost: about O(k n log n) time for the legible linkage, O(k n) memory: some 25·k·n bytes.
[[nodiscard]] Dendrogram makeDendrogram(const FootprintTable& footprints, const ClusterOptions& options,
                                        const ClusterContext& context = {}, const Progress& progress = {},
                                        const ArtifactSink& sink = {});

}  // namespace lodestone
