// Joining clusters that are each other's nearest, round by round.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/clustering/neighbour_graph.h"
#include "model/dendrogram.h"

namespace lodestone {

/// One join of two clusters, named by their smallest leaves.
struct Join {
  double distance = 0;         ///< metres
  double weight = 0;           ///< w
  std::uint32_t low = 0;       ///< smallest leaf of the one
  std::uint32_t high = 0;      ///< smallest leaf of the other, larger than `low`
  std::uint32_t lowSize = 1;   ///< leaves of the one
  std::uint32_t highSize = 1;  ///< leaves of the other
  bool forbidden = false;      ///< across a barrier
};

/// size · size, exact in double precision up to 2^26 leaves.
[[nodiscard]] inline double sizeProduct(std::uint32_t a, std::uint32_t b) {
  return static_cast<double>(a) * static_cast<double>(b);
}

/// How a linkage weighs a pair: w of methods.md 1.2. Monotone in size and distance, in floating point too.
enum class Weighing { BySize, Plain };
[[nodiscard]] inline double weightOf(Weighing weighing, double product, double distance) {
  return weighing == Weighing::BySize ? product * distance : distance;
}

/// Sorts joins as the greedy algorithm makes them: permitted before forbidden, then by (w, size·size, smaller
/// and larger of the two smallest leaves). A strict total order: no two joins of one tree share their `high`.
void sortGreedily(std::vector<Join>& joins);

/// What the joined nodes are: smallest leaf and size of each node of the graph.
struct Clusters {
  std::vector<std::uint32_t> smallestLeaf;
  std::vector<std::uint32_t> size;
};

/// All joins of the greedy algorithm on the graph, which always joins the pair that comes first; in no
/// particular order. The distance of two clusters is the smallest of any edge between them.
///
/// Any two clusters that are each other's first choice are joined at once, all such pairs in parallel. The
/// weight being reducible, in the full order of sortGreedily() (a join never makes a pair cheaper, and its
/// size product grows), the joins are those of the greedy algorithm; and every join comes after those inside
/// it, so sorting them gives the greedy order.
///
/// Cost: about O(E log n) for E edges of a graph like a city's. The graph's lists are used up.
/// Incomplete when a stop was requested.
[[nodiscard]] std::vector<Join> agglomerate(NeighbourGraph graph, Clusters clusters, Weighing weighing,
                                            const Progress& progress = {});

}  // namespace lodestone
