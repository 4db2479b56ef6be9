#include "algorithms/merging/merging.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "algorithms/clustering/footprint_distance.h"
#include "algorithms/geometry/predicates.h"
#include "algorithms/merging/merged_hull.h"
#include "algorithms/merging/shared_ground.h"

namespace lodestone {
namespace {

/// Memory for many small rings that live equally long.
class RingStore {
 public:
  std::span<const Vec2> keep(std::span<const Vec2> ring) {
    constexpr std::size_t kBlock = 1U << 16;  // vertices: 1 MiB
    if (blocks_.empty() || blocks_.back().capacity() - blocks_.back().size() < ring.size()) {
      blocks_.emplace_back().reserve(std::max(kBlock, ring.size()));
    }
    std::vector<Vec2>& block = blocks_.back();
    block.insert(block.end(), ring.begin(), ring.end());
    return {block.data() + block.size() - ring.size(), ring.size()};
  }

 private:
  std::vector<std::vector<Vec2>> blocks_;
};

struct Worker {
  MergedHull merger;
  RingStore store;
  Ring ring;
};

/// What a node passes up beside its ClusterNode.
struct Sums {
  double footprints = 0;  ///< Σ of footprint areas: the weights
  double heights = 0;     ///< Σ of footprint area × height
  double bases = 0;       ///< Σ of footprint area × base
  double covered = 0;     ///< area of the union of the footprints
};

std::size_t targetEdges(double ratio, std::size_t childEdges) {
  return static_cast<std::size_t>(std::floor(ratio * static_cast<double>(childEdges)));
}

/// Of the block over a cluster's hull; facesOfBlock() without a copy of the hull.
FaceCount facesOfHull(const ClusterNode& node) {
  if (node.edges < 3 || node.height <= 0) return {};
  return {2ULL * node.edges - 2, 4ULL * node.edges - 4};
}

class TreeMaker {
 public:
  TreeMaker(ClusterTree& tree, const Progress& progress)
      : tree_(tree),
        dendrogram_(*tree.dendrogram),
        footprints_(*tree.footprints),
        progress_(progress),
        hulls_(dendrogram_.nodeCount()),
        sums_(dendrogram_.nodeCount()),
        childrenLeft_(dendrogram_.merges.size()) {
    tree_.nodes.resize(dendrogram_.nodeCount());
    for (NodeId node = dendrogram_.leafCount; node < dendrogram_.nodeCount(); ++node) {
      const Merge& merge = dendrogram_.merge(node);
      tree_.nodes[node].a = merge.a;
      tree_.nodes[node].b = merge.b;
      tree_.nodes[node].size = merge.size;
      tree_.nodes[merge.a].parent = node;
      tree_.nodes[merge.b].parent = node;
      childrenLeft_[node - dendrogram_.leafCount] = 2;
    }
  }

  void run() {
    shared_ = sharedGround(footprints_, dendrogram_, progress_.part(0, 0.2));
    progress_.checkpoint();
    const std::vector<NodeId> leaves =
        leafOrder(dendrogram_).leaves;  // neighbours in the tree by the same thread
    constexpr std::size_t kGrain = 128;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, leaves.size(), kGrain), [&](const auto& range) {
      Worker& worker = workers_.local();
      for (std::size_t i = range.begin(); i < range.end() && !progress_.stopRequested(); ++i)
        climb(leaves[i], worker);
    });
    progress_.checkpoint();
    storeHulls();
  }

 private:
  /// Makes a leaf, and every node above it whose other child is done already.
  void climb(NodeId node, Worker& worker) {
    makeLeaf(node, worker);
    for (node = finish(node); node != kNoNode && !progress_.stopRequested(); node = finish(node))
      makeCluster(node, worker);
  }

  /// The parent, if `node` was the last of its children to be done.
  NodeId finish(NodeId node) {
    constexpr std::size_t kReportEvery = 4096;
    const std::size_t done = ++done_;
    if (done % kReportEvery == 0) {
      progress_.report(0.2 + 0.8 * static_cast<double>(done) / static_cast<double>(tree_.nodes.size()));
    }
    const NodeId parent = tree_.nodes[node].parent;
    return parent != kNoNode && --childrenLeft_[parent - dendrogram_.leafCount] == 0 ? parent : kNoNode;
  }

  void makeLeaf(NodeId leaf, Worker& worker) {
    const MultiPolygon footprint = footprints_.footprint(leaf);
    ClusterNode& node = tree_.nodes[leaf];
    node.base = footprints_.base[leaf];
    node.height = footprints_.height[leaf];
    node.minBase = node.base;
    node.maxTop = node.base + node.height;
    node.faces = footprints_.faces[leaf];
    const double ground = area(footprint);
    sums_[leaf] = {ground, ground * node.height, ground * node.base, ground};
    setHull(leaf, leafHull(footprint, worker), worker);
  }

  /// The outer ring without vertices in the middle of straight sides. Several rings, or one that touches
  /// itself, are merged.
  std::span<const Vec2> leafHull(const MultiPolygon& footprint, Worker& worker) const {
    if (footprint.size() == 1 && isSimple(footprint[0].outer)) {
      const Ring& outer = footprint[0].outer;
      const std::size_t n = outer.size();
      worker.ring.clear();
      for (std::size_t i = 0; i < n; ++i) {
        if (orientation(outer[(i + n - 1) % n], outer[i], outer[(i + 1) % n]) != 0)
          worker.ring.push_back(outer[i]);
      }
      if (signedArea(worker.ring) < 0) std::reverse(worker.ring.begin(), worker.ring.end());
      return worker.ring;
    }
    std::size_t edges = 0;
    std::vector<Ring> rings;
    for (const Polygon& polygon : footprint) {
      rings.push_back(polygon.outer);
      edges += polygon.outer.size();
    }
    worker.ring = mergedHull(rings, rings.size() > 1 ? targetEdges(tree_.options.edgeRatio, edges) : edges);
    return worker.ring;
  }

  void makeCluster(NodeId id, Worker& worker) {
    ClusterNode& node = tree_.nodes[id];
    const ClusterNode& a = tree_.nodes[node.a];
    const ClusterNode& b = tree_.nodes[node.b];
    const Sums& ofA = sums_[node.a];
    const Sums& ofB = sums_[node.b];
    Sums& sums = sums_[id];
    sums = {ofA.footprints + ofB.footprints, ofA.heights + ofB.heights, ofA.bases + ofB.bases,
            ofA.covered + ofB.covered - shared_[id]};
    const bool weighted = sums.footprints > 0;
    node.height = weighted ? sums.heights / sums.footprints : (a.height + b.height) / 2;
    node.base = weighted ? sums.bases / sums.footprints : (a.base + b.base) / 2;
    node.minBase = std::min(a.minBase, b.minBase);
    node.maxTop = std::max(a.maxTop, b.maxTop);
    setHull(id, clusterHull(hulls_[node.a], hulls_[node.b], worker), worker);
    node.gap = gapBetween(hulls_[node.a], hulls_[node.b]);
    node.faces = facesOfHull(node);
  }

  std::span<const Vec2> clusterHull(std::span<const Vec2> a, std::span<const Vec2> b, Worker& worker) const {
    if (a.empty() || b.empty()) return a.empty() ? b : a;  // a building without a footprint adds nothing
    const std::array children{a, b};
    return worker.merger.make(children, targetEdges(tree_.options.edgeRatio, a.size() + b.size()), true);
  }

  void setHull(NodeId id, std::span<const Vec2> hull, Worker& worker) {
    ClusterNode& node = tree_.nodes[id];
    hulls_[id] = worker.store.keep(hull);
    node.edges = static_cast<std::uint32_t>(hull.size());
    node.area = signedArea(hulls_[id]);
    node.negative = std::max(0.0, node.area - sums_[id].covered);
    for (const Vec2& p : hull) node.box.add(p);
  }

  void storeHulls() {
    std::uint64_t total = 0;
    for (NodeId id = 0; id < tree_.nodes.size(); ++id) {
      tree_.nodes[id].hullBegin = total;
      total += hulls_[id].size();
      if (tree_.isLeaf(id)) tree_.buildingFaces += tree_.nodes[id].faces;
    }
    tree_.hullVertices.resize(total);
    tbb::parallel_for(std::size_t{0}, hulls_.size(), [&](std::size_t id) {
      std::copy(hulls_[id].begin(), hulls_[id].end(),
                tree_.hullVertices.begin() + static_cast<std::ptrdiff_t>(tree_.nodes[id].hullBegin));
    });
  }

  ClusterTree& tree_;
  const Dendrogram& dendrogram_;
  const FootprintTable& footprints_;
  const Progress& progress_;
  std::vector<std::span<const Vec2>> hulls_;
  std::vector<Sums> sums_;
  std::vector<double> shared_;
  std::vector<std::atomic<std::uint8_t>> childrenLeft_;
  std::atomic<std::size_t> done_{0};
  tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace

Ring mergedHull(const std::vector<Ring>& children, std::size_t targetEdges) {
  std::vector<std::span<const Vec2>> rings;
  for (const Ring& child : children) {
    if (!child.empty()) rings.emplace_back(child);
  }
  const bool simple = std::all_of(children.begin(), children.end(),
                                  [](const Ring& ring) { return signedArea(ring) > 0 && isSimple(ring); });
  MergedHull merger;
  const std::span<const Vec2> hull = merger.make(rings, targetEdges, simple);
  return {hull.begin(), hull.end()};
}

ClusterTree makeClusterTree(std::shared_ptr<const FootprintTable> footprints,
                            std::shared_ptr<const Dendrogram> dendrogram, const MergeOptions& options,
                            const Progress& progress, const ArtifactSink& sink) {
  ClusterTree tree;
  tree.dendrogram = std::move(dendrogram);
  tree.footprints = std::move(footprints);
  tree.options = options;
  TreeMaker(tree, progress).run();
  progress.report(1);
  tell(sink, "merge", &tree);
  return tree;
}

}  // namespace lodestone
