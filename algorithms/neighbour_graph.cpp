#include "algorithms/neighbour_graph.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <tbb/parallel_invoke.h>

#include "algorithms/nearest_buildings.h"
#include "algorithms/pair_costs.h"
#include "algorithms/parallel.h"
#include "algorithms/spanning_tree.h"

namespace lodestone {
namespace {

constexpr std::size_t kGrain = 1024;

/// A pair of buildings that the spanning tree joins and the nearest ones do not.
struct ExtraPair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  double squared = 0;
};

class GraphBuilder {
 public:
  GraphBuilder(const PackedFootprints& packed, const NearestBuildings& nearest, const Progress& progress)
      : packed_(packed), nearest_(nearest), progress_(progress), degree_(packed.count()) {}

  /// Whether `squared` is among the nearest of `of`: one look at the last of them tells.
  [[nodiscard]] bool lists(std::uint32_t of, double squared, std::uint32_t other) const {
    if (nearest_.perSlot == 0) return false;
    const Neighbour last = nearest_.at(of, nearest_.perSlot - 1);
    if (squared != last.squared) return squared < last.squared;
    return packed_.building[other] <= packed_.building[last.slot];
  }

  NeighbourGraph build(const std::vector<ExtraPair>& extra) {
    countLinks(extra);
    NeighbourGraph graph;
    graph.start.resize(packed_.count() + std::size_t{1});
    for (std::uint32_t i = 0; i < packed_.count(); ++i) graph.start[i + 1] = graph.start[i] + degree_[i];
    if (progress_.stopRequested()) return graph;
    graph.links = std::make_unique_for_overwrite<Link[]>(graph.start.back());
    fill(graph, extra);
    return graph;
  }

 private:
  void countLinks(const std::vector<ExtraPair>& extra) {
    forPieces(0, packed_.count(), kGrain, progress_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        degree_[i].fetch_add(nearest_.perSlot, std::memory_order_relaxed);
      forOneSided(first, last, [&](std::uint32_t, const Neighbour& near) {
        degree_[near.slot].fetch_add(1, std::memory_order_relaxed);
      });
    });
    for (const ExtraPair& pair : extra) {
      ++degree_[pair.a];
      ++degree_[pair.b];
    }
  }

  /// Calls visit(i, near) where i lists `near`, but not the other way round.
  template <class Visit>
  void forOneSided(std::size_t first, std::size_t last, Visit&& visit) const {
    for (std::size_t i = first; i < last; ++i) {
      const auto of = static_cast<std::uint32_t>(i);
      for (std::uint32_t rank = 0; rank < nearest_.perSlot; ++rank) {
        const Neighbour near = nearest_.at(of, rank);
        if (!lists(near.slot, near.squared, of)) visit(of, near);
      }
    }
  }

  /// Own neighbours first, as they are sorted already; what others and the spanning tree add is further away
  /// and sorted behind them.
  void fill(NeighbourGraph& graph, const std::vector<ExtraPair>& extra) {
    forPieces(0, packed_.count(), kGrain, progress_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const std::span<Link> links = graph.linksOf(static_cast<std::uint32_t>(i));
        for (std::uint32_t rank = 0; rank < nearest_.perSlot; ++rank) {
          const Neighbour near = nearest_.at(static_cast<std::uint32_t>(i), rank);
          links[rank] = Link(near.slot, std::sqrt(near.squared));
        }
        degree_[i].store(nearest_.perSlot, std::memory_order_relaxed);
      }
    });
    const auto add = [&](std::uint32_t to, std::uint32_t from, double squared) {
      graph.linksOf(to)[degree_[to].fetch_add(1, std::memory_order_relaxed)] = Link(from, std::sqrt(squared));
    };
    forPieces(0, packed_.count(), kGrain, progress_, [&](std::size_t first, std::size_t last) {
      forOneSided(first, last,
                  [&](std::uint32_t i, const Neighbour& near) { add(near.slot, i, near.squared); });
    });
    for (const ExtraPair& pair : extra) {
      add(pair.a, pair.b, pair.squared);
      add(pair.b, pair.a, pair.squared);
    }
    forPieces(0, packed_.count(), kGrain, progress_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        sortLinks(graph.linksOf(static_cast<std::uint32_t>(i)).subspan(nearest_.perSlot));
      }
    });
  }

  const PackedFootprints& packed_;
  const NearestBuildings& nearest_;
  const Progress& progress_;
  std::vector<std::atomic<std::uint32_t>> degree_;
};

/// Slot of every vertex of the table.
std::vector<std::uint32_t> slotOfVertex(const PackedFootprints& packed, const FootprintTable& table) {
  std::vector<std::uint32_t> slots(table.vertices.size());
  for (std::uint32_t slot = 0; slot < packed.count(); ++slot) {
    const std::uint32_t b = packed.building[slot];
    std::fill(slots.begin() + table.ringStart[table.buildingRing[b]],
              slots.begin() + table.ringStart[table.buildingRing[b + 1]], slot);
  }
  return slots;
}

/// The pairs of slots that edges of the spanning tree join, each once; without those that the edge's length
/// alone shows to be among the nearest.
std::vector<std::pair<std::uint32_t, std::uint32_t>> joinedPairs(const PackedFootprints& packed,
                                                                 const FootprintTable& table,
                                                                 const std::vector<SpanningEdge>& tree,
                                                                 const GraphBuilder& builder) {
  const std::vector<std::uint32_t> slots = slotOfVertex(packed, table);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const SpanningEdge& edge : tree) {
    const auto [a, b] = std::minmax(slots[edge.a], slots[edge.b]);
    if (a != b && !builder.lists(a, edge.squared, b)) pairs.emplace_back(a, b);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<ExtraPair> extraPairs(const PackedFootprints& packed, const FootprintTable& table,
                                  FootprintDistance distance, const std::vector<SpanningEdge>& tree,
                                  const GraphBuilder& builder, const Progress& progress) {
  const auto pairs = joinedPairs(packed, table, tree, builder);
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
  GraphBuilder builder(packed, nearest, progress);
  const std::vector<ExtraPair> extra =
      extraPairs(packed, footprints, options.distance, tree, builder, progress);
  tree = {};
  NeighbourGraph graph = builder.build(extra);
  if (progress.stopRequested()) return {};
  applyCosts(graph, packed, PairCosts(footprints, options, context), progress.part(0.8, 1));
  return graph;
}

}  // namespace lodestone
