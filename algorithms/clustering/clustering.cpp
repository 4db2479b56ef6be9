#include "algorithms/clustering/clustering.h"

#include <algorithm>
#include <numeric>

#include "algorithms/clustering/agglomeration.h"
#include "algorithms/clustering/linkages.h"
#include "algorithms/clustering/neighbour_graph.h"

namespace lodestone {
namespace {

/// Numbers the nodes in the order of the joins and adds what Eq. (1) says of each.
void addMerges(Dendrogram& dendrogram, const std::vector<Join>& joins) {
  std::vector<NodeId> nodeOf(dendrogram.leafCount);  // by smallest leaf: the cluster's node
  std::iota(nodeOf.begin(), nodeOf.end(), 0U);
  std::uint64_t sizes = 0;
  double greatest = 0;
  dendrogram.merges.reserve(joins.size());
  for (const Join& join : joins) {
    Merge merge{nodeOf[join.low], nodeOf[join.high], join.distance, join.weight};
    merge.size = join.lowSize + join.highSize;
    greatest = std::max(greatest, merge.weight);
    if (join.forbidden) merge.weight = greatest;
    const auto made = static_cast<double>(dendrogram.merges.size());
    const double average = made == 0 ? 1 : static_cast<double>(sizes) / made;
    merge.cost = merge.weight / (average * average);
    nodeOf[join.low] = dendrogram.nodeCount();
    dendrogram.merges.push_back(merge);
    sizes += merge.size;
  }
}

/// The joins of the linkage that the options name, in their order.
std::vector<Join> joinsOf(const FootprintTable& footprints, const ClusterOptions& options,
                          const ClusterContext& context, const Progress& progress) {
  const PackedFootprints packed = packFootprints(footprints, progress.part(0, 0.05, "cluster: sort"));
  progress.checkpoint();
  const Progress rest = progress.part(0.05, 1);
  if (options.linkage == Linkage::KMeans) return bisectingKMeans(packed, rest.part(0, 1, "cluster: divide"));
  if (options.linkage == Linkage::Complete) {
    return completeLink(packed, footprints, options, context, rest.part(0, 1, "cluster: join"));
  }
  NeighbourGraph graph =
      neighbourGraph(packed, footprints, options, context, rest.part(0, 0.7, "cluster: neighbours"));
  progress.checkpoint();
  const Progress joining = rest.part(0.7, 1, "cluster: join");
  Clusters clusters{packed.building, std::vector<std::uint32_t>(packed.count(), 1)};
  if (options.linkage == Linkage::Single) return singleLink(graph, std::move(clusters), joining);
  std::vector<Join> joins = agglomerate(std::move(graph), std::move(clusters), Weighing::BySize, joining);
  if (!progress.stopRequested()) sortGreedily(joins);
  return joins;
}

}  // namespace

Dendrogram makeDendrogram(const FootprintTable& footprints, const ClusterOptions& options,
                          const ClusterContext& context, const Progress& progress, const ArtifactSink& sink) {
  Dendrogram dendrogram;
  dendrogram.options = options;
  dendrogram.leafCount = static_cast<std::uint32_t>(footprints.buildingCount());
  const std::vector<Join> joins = joinsOf(footprints, options, context, progress);
  progress.checkpoint();
  addMerges(dendrogram, joins);
  dendrogram.depth = depthOf(dendrogram);
  progress.checkpoint();
  progress.report(1);
  tell(sink, "cluster", &dendrogram);
  return dendrogram;
}

}  // namespace lodestone
