#include "algorithms/clustering/agglomeration.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_sort.h>

#include "algorithms/geometry/parallel.h"

namespace lodestone {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;
constexpr std::size_t kGrain = 64;  // clusters a task; fewer are done without one

template <class T>
std::atomic_ref<T> shared(T& value) {
  return std::atomic_ref<T>(value);
}

/// The partner that a cluster would join first.
struct Choice {
  double distance = 0;
  std::uint32_t partner = kNone;
  bool forbidden = false;
};

/// Room for one thread to work in.
struct Scratch {
  std::vector<std::uint32_t> seen;  ///< by node: the list in which it was seen last
  std::uint32_t list = 0;
  std::vector<Link> links;
  SpareLists spare;
  std::vector<std::uint32_t> changed;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

bool isNearer(const Link& a, const Link& b) {
  return a.forbidden() != b.forbidden() ? b.forbidden() : a.distance() < b.distance();
}

class Agglomeration {
 public:
  Agglomeration(NeighbourGraph graph, Clusters clusters, Weighing weighing, const Progress& progress)
      : graph_(std::move(graph)),
        clusters_(std::move(clusters)),
        weighing_(weighing),
        progress_(progress),
        nodes_(graph_.nodeCount()),
        parent_(nodes_),
        choice_(nodes_),
        changedIn_(nodes_, 0) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::vector<Join> run() {
    std::vector<std::uint32_t> changed(nodes_);
    std::iota(changed.begin(), changed.end(), 0U);
    std::vector<Join> joins;
    joins.reserve(nodes_);
    for (std::uint32_t round = 1; !changed.empty() && !progress_.stopRequested(); ++round) {
      choose(changed);
      const Pairs pairs = mutualPairs(changed, round);
      unite(pairs, joins);
      changed = mergeLists(pairs, round);
      progress_.report(static_cast<double>(joins.size()) / static_cast<double>(nodes_));
    }
    return joins;
  }

 private:
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  /// The cluster that a node belongs to.
  std::uint32_t find(std::uint32_t node) {
    std::uint32_t parent = shared(parent_[node]).load(std::memory_order_relaxed);
    while (parent != node) {  // path halving; a lost race leaves a longer path, never a wrong one
      const std::uint32_t above = shared(parent_[parent]).load(std::memory_order_relaxed);
      if (above != parent) shared(parent_[node]).store(above, std::memory_order_relaxed);
      node = parent;
      parent = above;
    }
    return node;
  }

  void choose(const std::vector<std::uint32_t>& changed) {
    forPieces(0, changed.size(), kGrain, progress_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) choice_[changed[i]] = choiceOf(changed[i]);
    });
  }

  /// Goes through the links, nearest first, until no further one can weigh as little as the best.
  Choice choiceOf(std::uint32_t node) {
    Choice best;
    double weight = 0;
    double product = 0;
    for (Link& link : graph_.linksOf(node)) {
      const double distance = link.distance();
      if (best.partner != kNone &&
          (link.forbidden() != best.forbidden ||
           weightOf(weighing_, sizeProduct(clusters_.size[node], 1), distance) > weight)) {
        break;
      }
      const std::uint32_t other = find(link.to());
      link.retarget(other);
      if (other == node) continue;
      const double otherProduct = sizeProduct(clusters_.size[node], clusters_.size[other]);
      const double otherWeight = weightOf(weighing_, otherProduct, distance);
      const bool better =
          best.partner == kNone || otherWeight < weight ||
          (otherWeight == weight &&
           (otherProduct < product || (otherProduct == product && leavesFirst(node, other, best.partner))));
      if (!better) continue;
      best = {distance, other, link.forbidden()};
      weight = otherWeight;
      product = otherProduct;
    }
    return best;
  }

  /// Whether the pair (node, a) comes before (node, b) by their smallest leaves.
  [[nodiscard]] bool leavesFirst(std::uint32_t node, std::uint32_t a, std::uint32_t b) const {
    const std::vector<std::uint32_t>& leaf = clusters_.smallestLeaf;
    return std::minmax(leaf[node], leaf[a]) < std::minmax(leaf[node], leaf[b]);
  }

  Pairs mutualPairs(const std::vector<std::uint32_t>& changed, std::uint32_t round) {
    forPieces(0, changed.size(), kGrain * 16, progress_, [&](std::size_t first, std::size_t last) {
      Pairs& pairs = scratch_.local().pairs;
      for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t node = changed[i];
        const std::uint32_t partner = choice_[node].partner;
        if (partner == kNone || choice_[partner].partner != node) continue;
        // A pair of which both ends changed is met twice.
        if (node < partner || changedIn_[partner] != round - 1) pairs.emplace_back(node, partner);
      }
    });
    return gathered(&Scratch::pairs);
  }

  void unite(const Pairs& pairs, std::vector<Join>& joins) {
    const std::size_t before = joins.size();
    joins.resize(before + pairs.size());
    forPieces(0, pairs.size(), kGrain * 16, progress_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) joins[before + i] = unite(pairs[i].first, pairs[i].second);
    });
  }

  Join unite(std::uint32_t kept, std::uint32_t dropped) {
    const Choice& choice = choice_[kept];
    std::uint32_t& leaf = clusters_.smallestLeaf[kept];
    std::uint32_t& size = clusters_.size[kept];
    const std::uint32_t otherSize = clusters_.size[dropped];
    Join join{choice.distance,
              weightOf(weighing_, sizeProduct(size, otherSize), choice.distance),
              leaf,
              clusters_.smallestLeaf[dropped],
              size,
              otherSize,
              choice.forbidden};
    if (join.low > join.high) {
      std::swap(join.low, join.high);
      std::swap(join.lowSize, join.highSize);
    }
    parent_[dropped] = kept;
    leaf = join.low;
    size = join.lowSize + join.highSize;
    return join;
  }

  /// Gives each kept cluster the links of both, and returns all clusters whose choice has to be made again:
  /// the kept ones, and those that had chosen one of a pair. All others keep theirs, since nothing became
  /// cheaper.
  std::vector<std::uint32_t> mergeLists(const Pairs& pairs, std::uint32_t round) {
    forPieces(0, pairs.size(), kGrain / 4, progress_, [&](std::size_t first, std::size_t last) {
      Scratch& scratch = scratch_.local();
      scratch.seen.resize(nodes_, 0);
      for (std::size_t i = first; i < last; ++i) {
        const auto [kept, dropped] = pairs[i];
        mergeLinks(kept, dropped, scratch);
        mark(kept, round, scratch);
        for (const Link& link : graph_.linksOf(kept)) {
          const std::uint32_t chosen = choice_[link.to()].partner;
          if (chosen == kept || chosen == dropped) mark(link.to(), round, scratch);
        }
      }
    });
    return gathered(&Scratch::changed);
  }

  void mark(std::uint32_t node, std::uint32_t round, Scratch& scratch) {
    if (shared(changedIn_[node]).exchange(round, std::memory_order_relaxed) != round)
      scratch.changed.push_back(node);
  }

  /// Merges two sorted lists; of several links to one cluster the nearest stays.
  void mergeLinks(std::uint32_t kept, std::uint32_t dropped, Scratch& scratch) {
    ++scratch.list;
    scratch.links.clear();
    const auto take = [&](const Link& link) {
      const std::uint32_t other = find(link.to());
      if (other == kept || scratch.seen[other] == scratch.list) return;
      scratch.seen[other] = scratch.list;
      scratch.links.push_back(link);
      scratch.links.back().retarget(other);
    };
    const std::span<Link> a = graph_.linksOf(kept);
    const std::span<Link> b = graph_.linksOf(dropped);
    std::size_t j = 0;
    for (const Link& link : a) {
      while (j < b.size() && isNearer(b[j], link)) take(b[j++]);
      take(link);
    }
    while (j < b.size()) take(b[j++]);
    keepLinks(graph_.lists[kept], graph_.lists[dropped], scratch);
  }

  /// Puts the links where the larger of two lists was, if they fit there.
  static void keepLinks(LinkList& kept, LinkList& dropped, Scratch& scratch) {
    if (kept.capacity() < dropped.capacity()) std::swap(kept, dropped);
    scratch.spare.put(std::move(dropped));
    if (kept.capacity() < scratch.links.size())
      scratch.spare.put(std::exchange(kept, scratch.spare.take(scratch.links.size())));
    kept.assign(scratch.links);
  }

  /// Takes what the threads have collected. Its order depends on them; no result does.
  template <class T>
  std::vector<T> gathered(std::vector<T> Scratch::*member) {
    std::vector<T> all;
    for (Scratch& scratch : scratch_) {
      all.insert(all.end(), (scratch.*member).begin(), (scratch.*member).end());
      (scratch.*member).clear();
    }
    return all;
  }

  NeighbourGraph graph_;
  Clusters clusters_;
  Weighing weighing_;
  const Progress& progress_;
  std::uint32_t nodes_;
  std::vector<std::uint32_t> parent_;
  std::vector<Choice> choice_;
  std::vector<std::uint32_t> changedIn_;  ///< by node: the last round that changed its choice
  tbb::enumerable_thread_specific<Scratch> scratch_;
};

}  // namespace

void sortGreedily(std::vector<Join>& joins) {
  const auto key = [](const Join& join) {
    return std::tuple(join.forbidden, join.weight, sizeProduct(join.lowSize, join.highSize), join.low,
                      join.high);
  };
  tbb::parallel_sort(joins, [&](const Join& a, const Join& b) { return key(a) < key(b); });
}

std::vector<Join> agglomerate(NeighbourGraph graph, Clusters clusters, Weighing weighing,
                              const Progress& progress) {
  return Agglomeration(std::move(graph), std::move(clusters), weighing, progress).run();
}

}  // namespace lodestone
