#include "algorithms/clustering/neighbour_graph.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_invoke.h>

#include "algorithms/clustering/nearest_buildings.h"
#include "algorithms/clustering/pair_costs.h"
#include "algorithms/clustering/spanning_tree.h"
#include "algorithms/geometry/parallel.h"

namespace lodestone {
namespace {

constexpr std::size_t kGrain = 1024;

using SlotPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// A pair of buildings that the spanning tree joins and the nearest ones do not.
struct ExtraPair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  double squared = 0;
};

/// Makes lists of nearest buildings symmetric. What is added to a list stands behind it: those that a
/// building does not list itself are farther away than all that it does.
class GraphBuilder {
 public:
  GraphBuilder(const PackedFootprints& packed, NearestBuildings nearest, const Progress& progress)
      : packed_(packed), nearest_(std::move(nearest)), progress_(progress), added_(packed.count()) {}

  /// Whether slot `of` lists `other`, at that distance, by itself.
  [[nodiscard]] bool lists(std::uint32_t of, double squared, std::uint32_t other) const {
    return nearest_.names(of, squared, packed_.building[other]);
  }

  NeighbourGraph build(const std::vector<ExtraPair>& extra) {
    countAdded(extra);
    startOfAdded_.resize(packed_.count() + std::size_t{1});
    for (std::uint32_t i = 0; i < packed_.count(); ++i) {
      startOfAdded_[i + 1] = startOfAdded_[i] + added_[i].exchange(0, std::memory_order_relaxed);
    }
    addedLinks_ = std::make_unique_for_overwrite<Link[]>(startOfAdded_.back());
    collectAdded(extra);
    forPieces(0, packed_.count(), kGrain, progress_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) complete(static_cast<std::uint32_t>(i));
    });
    return {std::move(nearest_.lists)};
  }

 private:
  void countAdded(const std::vector<ExtraPair>& extra) {
    forOneSided(
        [&](std::uint32_t, const Link& near) { added_[near.to()].fetch_add(1, std::memory_order_relaxed); });
    for (const ExtraPair& pair : extra) {
      ++added_[pair.a];
      ++added_[pair.b];
    }
  }

  void collectAdded(const std::vector<ExtraPair>& extra) {
    const auto add = [&](std::uint32_t to, std::uint32_t from, double squared) {
      const std::uint64_t at = startOfAdded_[to] + added_[to].fetch_add(1, std::memory_order_relaxed);
      addedLinks_[at] = Link(from, squared);
    };
    forOneSided([&](std::uint32_t i, const Link& near) { add(near.to(), i, near.distance()); });
    for (const ExtraPair& pair : extra) {
      add(pair.a, pair.b, pair.squared);
      add(pair.b, pair.a, pair.squared);
    }
  }

  /// Calls visit(i, near) where i lists `near`, but not the other way round.
  template <class Visit>
  void forOneSided(Visit&& visit) const {
    forPieces(0, packed_.count(), kGrain, progress_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const auto of = static_cast<std::uint32_t>(i);
        for (const Link& near : nearest_.lists[i].span()) {
          if (!lists(near.to(), near.distance(), of)) visit(of, near);
        }
      }
    });
  }

  /// Appends what was collected for a list, and turns squared distances into metres.
  void complete(std::uint32_t slot) {
    LinkList& list = nearest_.lists[slot];
    const std::span<const Link> added(addedLinks_.get() + startOfAdded_[slot],
                                      addedLinks_.get() + startOfAdded_[slot + 1]);
    if (!added.empty()) {
      LinkList all(list.size() + added.size());
      const auto end = std::copy(list.span().begin(), list.span().end(), all.span().begin());
      std::copy(added.begin(), added.end(), end);
      const std::size_t own = list.size();
      list = std::move(all);
      toMetres(list.span());
      sortLinks(list.span().subspan(own));
    } else {
      toMetres(list.span());
    }
  }

  static void toMetres(std::span<Link> links) {
    for (Link& link : links) link = Link(link.to(), std::sqrt(link.distance()));
  }

  const PackedFootprints& packed_;
  NearestBuildings nearest_;
  const Progress& progress_;
  std::vector<std::atomic<std::uint32_t>> added_;  ///< by slot
  std::vector<std::uint64_t> startOfAdded_;
  std::unique_ptr<Link[]> addedLinks_;  ///< of all slots, squared distances
};

/// Slot of every vertex of the table.
std::vector<std::uint32_t> slotOfVertex(const PackedFootprints& packed, const FootprintTable& table,
                                        const Progress& progress) {
  std::vector<std::uint32_t> slots(table.vertices.size());
  forPieces(0, packed.count(), kGrain, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t slot = first; slot < last; ++slot) {
      const std::uint32_t b = packed.building[slot];
      std::fill(slots.begin() + table.ringStart[table.buildingRing[b]],
                slots.begin() + table.ringStart[table.buildingRing[b + 1]], static_cast<std::uint32_t>(slot));
    }
  });
  return slots;
}

/// The pairs of slots that edges of the spanning tree join, each once; without those that the edge's length
/// alone shows to be among the nearest.
SlotPairs joinedPairs(const PackedFootprints& packed, const FootprintTable& table,
                      const std::vector<SpanningEdge>& tree, const GraphBuilder& builder,
                      const Progress& progress) {
  const std::vector<std::uint32_t> slots = slotOfVertex(packed, table, progress);
  tbb::enumerable_thread_specific<SlotPairs> found;
  forPieces(0, tree.size(), kGrain * 16, progress, [&](std::size_t first, std::size_t last) {
    SlotPairs& pairs = found.local();
    for (std::size_t i = first; i < last; ++i) {
      const SpanningEdge& edge = tree[i];
      const auto [a, b] = std::minmax(slots[edge.a], slots[edge.b]);
      if (a != b && !builder.lists(a, edge.squared, b)) pairs.emplace_back(a, b);
    }
  });
  SlotPairs pairs;
  for (const SlotPairs& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<ExtraPair> extraPairs(const PackedFootprints& packed, const FootprintTable& table,
                                  FootprintDistance distance, const std::vector<SpanningEdge>& tree,
                                  const GraphBuilder& builder, const Progress& progress) {
  const SlotPairs pairs = joinedPairs(packed, table, tree, builder, progress);
  std::vector<ExtraPair> extra(pairs.size());
  forPieces(0, pairs.size(), 256, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto [a, b] = pairs[i];
      extra[i] = {a, b, closestPoints(table, packed.building[a], packed.building[b], distance).squared};
    }
  });
  std::erase_if(extra, [&](const ExtraPair& pair) {
    return builder.lists(pair.a, pair.squared, pair.b) || builder.lists(pair.b, pair.squared, pair.a);
  });
  return extra;
}

/// Each pair is measured twice, once from each end, with the same result.
void applyCosts(NeighbourGraph& graph, const PackedFootprints& packed, const PairCosts& costs,
                const Progress& progress) {
  if (!costs.any()) return;
  forPiecesReported(graph.nodeCount(), 64, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const std::span<Link> links = graph.linksOf(static_cast<std::uint32_t>(i));
      for (Link& link : links) {
        const PairCost cost = costs.of(packed.building[i], packed.building[link.to()], link.distance());
        link = Link(link.to(), cost.distance, cost.forbidden);
      }
      sortLinks(links);
    }
  });
}

}  // namespace

void sortLinks(std::span<Link> links) {
  std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
    if (a.forbidden() != b.forbidden()) return b.forbidden();
    return a.distance() != b.distance() ? a.distance() < b.distance() : a.to() < b.to();
  });
}

NeighbourGraph neighbourGraph(const PackedFootprints& packed, const FootprintTable& footprints,
                              const ClusterOptions& options, const ClusterContext& context,
                              const Progress& progress) {
  NearestBuildings nearest;
  std::vector<SpanningEdge> tree;
  const Progress silent({}, progress.stopToken());  // one bar, moved by the longer of the two
  tbb::parallel_invoke([&] { tree = spanningTree(footprints.vertices, silent); },
                       [&] {
                         nearest = nearestBuildings(packed, footprints, options.distance,
                                                    static_cast<std::uint32_t>(options.neighbours),
                                                    progress.part(0, 0.8));
                       });
  if (progress.stopRequested()) return {};
  GraphBuilder builder(packed, std::move(nearest), progress);
  const std::vector<ExtraPair> extra =
      extraPairs(packed, footprints, options.distance, tree, builder, progress);
  tree = {};
  NeighbourGraph graph = builder.build(extra);
  if (progress.stopRequested()) return {};
  applyCosts(graph, packed, PairCosts(footprints, options, context), progress.part(0.8, 1));
  return graph;
}

}  // namespace lodestone
