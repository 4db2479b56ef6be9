#include <algorithm>
#include <map>
#include <span>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_sort.h>

#include "algorithms/clustering/linkages.h"
#include "algorithms/geometry/disjoint_sets.h"
#include "algorithms/geometry/parallel.h"

namespace lodestone {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr std::size_t kBuckets =
    64;  // edges are sorted in so many steps, each after the last has joined what it could

struct Edge {
  double distance = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  bool forbidden = false;
  [[nodiscard]] auto key() const { return std::pair(forbidden, distance); }
};

class SingleLink {
 public:
  SingleLink(const NeighbourGraph& graph, Clusters leaves, const Progress& progress)
      : graph_(graph),
        clusters_(std::move(leaves)),
        progress_(progress),
        sets_(graph.nodeCount()),
        taken_(graph.nodeCount(), 0) {}

  std::vector<Join> run() {
    for (const auto& limit : limits()) {
      std::vector<Edge> edges = edgesUpTo(limit);
      if (progress_.stopRequested()) break;
      tbb::parallel_sort(edges, [](const Edge& a, const Edge& b) { return a.key() < b.key(); });
      for (std::size_t first = 0, last = 0; first < edges.size() && !progress_.stopRequested();
           first = last) {
        while (last < edges.size() && edges[last].key() == edges[first].key()) ++last;
        joinEqual({edges.data() + first, edges.data() + last});
      }
      progress_.report(static_cast<double>(joins_.size()) / static_cast<double>(graph_.nodeCount()));
    }
    return std::move(joins_);
  }

 private:
  using Limit = std::pair<bool, double>;

  /// Quantiles of a sample of the edges, and infinity; permitted edges first.
  [[nodiscard]] std::vector<Limit> limits() const {
    std::vector<Limit> sample;
    std::size_t total = 0;
    for (const LinkList& list : graph_.lists) total += list.size();
    const std::size_t step = std::max<std::size_t>(1, total / (kBuckets * 64));
    std::size_t next = 0;  // place of the next one taken, in the list at hand
    for (const LinkList& list : graph_.lists) {
      for (; next < list.size(); next += step)
        sample.emplace_back(list.span()[next].forbidden(), list.span()[next].distance());
      next -= list.size();
    }
    std::sort(sample.begin(), sample.end());
    std::vector<Limit> result;
    for (std::size_t b = 1; b < kBuckets && !sample.empty(); ++b)
      result.push_back(sample[b * sample.size() / kBuckets]);
    result.emplace_back(true, std::numeric_limits<double>::infinity());
    return result;
  }

  /// The edges up to the limit that were not asked for before and join different clusters.
  std::vector<Edge> edgesUpTo(const Limit& limit) {
    tbb::enumerable_thread_specific<std::vector<Edge>> found;
    forPieces(0, graph_.nodeCount(), kGrain, progress_, [&](std::size_t first, std::size_t last) {
      std::vector<Edge>& edges = found.local();
      for (std::size_t i = first; i < last; ++i) {
        const auto node = static_cast<std::uint32_t>(i);
        const std::span<const Link> links = graph_.linksOf(node);
        for (; taken_[i] < links.size(); ++taken_[i]) {
          const Link& link = links[taken_[i]];
          if (Limit(link.forbidden(), link.distance()) > limit) break;
          if (node < link.to() && sets_.root(node) != sets_.root(link.to())) {
            edges.push_back({link.distance(), node, link.to(), link.forbidden()});
          }
        }
      }
    });
    std::vector<Edge> all;
    for (const std::vector<Edge>& edges : found) all.insert(all.end(), edges.begin(), edges.end());
    return all;
  }

  /// Joins along edges of one length. Which go first is decided by the sizes of clusters, and so by what has
  /// been joined: that is what agglomerate() is for.
  void joinEqual(std::span<const Edge> edges) {
    std::vector<Edge> open;
    for (const Edge& edge : edges) {
      const std::uint32_t a = sets_.find(edge.a);
      const std::uint32_t b = sets_.find(edge.b);
      if (a != b) open.push_back({edge.distance, a, b, edge.forbidden});
    }
    if (open.size() == 1) {
      joinOne(open.front());
    } else if (!open.empty()) {
      joinSeveral(open);
    }
  }

  void joinOne(const Edge& edge) {
    const auto [leafA, leafB] = std::pair(clusters_.smallestLeaf[edge.a], clusters_.smallestLeaf[edge.b]);
    const auto [sizeA, sizeB] = std::pair(clusters_.size[edge.a], clusters_.size[edge.b]);
    Join join{edge.distance, edge.distance, leafA, leafB, sizeA, sizeB, edge.forbidden};
    if (leafA > leafB) join = {edge.distance, edge.distance, leafB, leafA, sizeB, sizeA, edge.forbidden};
    joins_.push_back(join);
    unite(edge.a, edge.b);
  }

  /// \pre the ends of the edges are sets.
  void joinSeveral(std::vector<Edge>& open) {
    std::map<std::uint32_t, std::uint32_t> local;  // by set
    for (const Edge& edge : open) {
      local.emplace(edge.a, 0);
      local.emplace(edge.b, 0);
    }
    Clusters clusters;
    for (auto& [set, number] : local) {
      number = static_cast<std::uint32_t>(clusters.size.size());
      clusters.smallestLeaf.push_back(clusters_.smallestLeaf[set]);
      clusters.size.push_back(clusters_.size[set]);
    }
    for (Edge& edge : open) {
      unite(edge.a, edge.b);
      edge.a = local[edge.a];
      edge.b = local[edge.b];
    }
    std::vector<Join> joins = agglomerate(graphOf(open, local.size()), std::move(clusters), Weighing::Plain,
                                          Progress({}, progress_.stopToken()));
    sortGreedily(joins);
    joins_.insert(joins_.end(), joins.begin(), joins.end());
  }

  void unite(std::uint32_t a, std::uint32_t b) {
    a = sets_.find(a);
    b = sets_.find(b);
    if (!sets_.join(a, b)) return;
    const std::uint32_t set = sets_.find(a);
    clusters_.smallestLeaf[set] = std::min(clusters_.smallestLeaf[a], clusters_.smallestLeaf[b]);
    clusters_.size[set] = clusters_.size[a] + clusters_.size[b];
  }

  static NeighbourGraph graphOf(std::span<const Edge> edges, std::size_t nodes) {
    std::vector<std::vector<Link>> links(nodes);
    for (const Edge& edge : edges) {
      links[edge.a].emplace_back(edge.b, edge.distance, edge.forbidden);
      links[edge.b].emplace_back(edge.a, edge.distance, edge.forbidden);
    }
    NeighbourGraph graph;
    for (const std::vector<Link>& list : links) graph.lists.emplace_back(list);
    return graph;
  }

  const NeighbourGraph& graph_;
  Clusters clusters_;
  const Progress& progress_;
  DisjointSets sets_;
  std::vector<std::uint32_t> taken_;  ///< by node: links already asked for
  std::vector<Join> joins_;
};

}  // namespace

std::vector<Join> singleLink(const NeighbourGraph& graph, Clusters leaves, const Progress& progress) {
  return SingleLink(graph, std::move(leaves), progress).run();
}

}  // namespace lodestone
