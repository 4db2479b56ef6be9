#include "algorithms/clustering.h"

#include <algorithm>

#include <tbb/parallel_sort.h>

#include "algorithms/agglomeration.h"
#include "algorithms/neighbour_graph.h"

namespace lodestone {
namespace {

/// Numbers the nodes in the order of the joins and adds what Eq. (1) says of each.
void addMerges(Dendrogram& dendrogram, const std::vector<Join>& joins, Weighing weighing) {
  std::vector<NodeId> nodeOf(dendrogram.leafCount);  // by smallest leaf: the cluster's node
  for (NodeId leaf = 0; leaf < dendrogram.leafCount; ++leaf) nodeOf[leaf] = leaf;
  std::uint64_t sizes = 0;
  double greatest = 0;
  dendrogram.merges.reserve(joins.size());
  for (const Join& join : joins) {
    Merge merge{nodeOf[join.low], nodeOf[join.high], join.distance};
    merge.size = join.lowSize + join.highSize;
    merge.weight = weightOf(weighing, sizeProduct(join.lowSize, join.highSize), join.distance);
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

}  // namespace

Dendrogram makeDendrogram(const FootprintTable& footprints, const ClusterOptions& options,
                          const ClusterContext& context, const Progress& progress, const ArtifactSink& sink) {
  Dendrogram dendrogram;
  dendrogram.options = options;
  dendrogram.leafCount = static_cast<std::uint32_t>(footprints.buildingCount());
  const Weighing weighing = options.linkage == Linkage::Single ? Weighing::Plain : Weighing::BySize;
  const PackedFootprints packed = packFootprints(footprints, progress.part(0, 0.05, "cluster: sort"));
  progress.checkpoint();
  NeighbourGraph graph =
      neighbourGraph(packed, footprints, options, context, progress.part(0.05, 0.7, "cluster: neighbours"));
  progress.checkpoint();
  Clusters clusters{packed.building, std::vector<std::uint32_t>(packed.count(), 1)};
  std::vector<Join> joins =
      agglomerate(std::move(graph), std::move(clusters), weighing, progress.part(0.7, 0.98, "cluster: join"));
  progress.checkpoint();
  tbb::parallel_sort(joins, [weighing](const Join& a, const Join& b) { return comesBefore(weighing, a, b); });
  addMerges(dendrogram, joins, weighing);
  dendrogram.depth = depthOf(dendrogram);
  progress.checkpoint();
  progress.report(1);
  tell(sink, "cluster", &dendrogram);
  return dendrogram;
}

}  // namespace lodestone
