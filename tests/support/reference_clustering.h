// The paper's clustering by brute force: what the fast one is compared with.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

#include "algorithms/clustering/clustering.h"
#include "algorithms/clustering/footprint_distance.h"

namespace lodestone::test {

/// Cost of a pair of buildings: distance in metres and whether it is forbidden.
struct ReferencePair {
  double distance = 0;
  bool forbidden = false;
};
using ReferenceCost = std::function<ReferencePair(std::uint32_t a, std::uint32_t b, double distance)>;
using ReferenceGraph = std::map<std::pair<std::uint32_t, std::uint32_t>, ReferencePair>;

/// Closest vertices, straight from the definition.
inline double vertexDistanceSquared(const FootprintTable& table, std::uint32_t a, std::uint32_t b) {
  double best = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = table.ringStart[table.buildingRing[a]];
       i < table.ringStart[table.buildingRing[a + 1]]; ++i) {
    for (std::uint32_t j = table.ringStart[table.buildingRing[b]];
         j < table.ringStart[table.buildingRing[b + 1]]; ++j) {
      const double dx = table.vertices[i].x() - table.vertices[j].x();
      const double dy = table.vertices[i].y() - table.vertices[j].y();
      best = std::min(best, dx * dx + dy * dy);
    }
  }
  return best;
}

/// Prim's algorithm over all pairs of vertices, with the order (squared length, smaller, larger vertex).
/// O(V²).
inline std::vector<std::pair<std::uint32_t, std::uint32_t>> referenceSpanningTree(
    const std::vector<Vec2>& points) {
  using Key = std::tuple<double, std::uint32_t, std::uint32_t>;
  const auto n = static_cast<std::uint32_t>(points.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<bool> inTree(n, false);
  const Key none{std::numeric_limits<double>::infinity(), 0, 0};
  std::vector<Key> best(n, none);
  for (std::uint32_t at = 0, step = 1; step < n; ++step) {
    inTree[at] = true;
    std::uint32_t next = n;
    for (std::uint32_t v = 0; v < n; ++v) {
      if (inTree[v]) continue;
      const double dx = points[at].x() - points[v].x();
      const double dy = points[at].y() - points[v].y();
      best[v] = std::min(best[v], Key{dx * dx + dy * dy, std::min(at, v), std::max(at, v)});
      if (next == n || best[v] < best[next]) next = v;
    }
    edges.emplace_back(std::get<1>(best[next]), std::get<2>(best[next]));
    at = next;
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Neighbour graph of methods.md 1.2 from all pairs. O(n²) pairs and O(V²) for the spanning tree.
inline ReferenceGraph referenceGraph(const FootprintTable& table, const ClusterOptions& options,
                                     const ReferenceCost& cost) {
  const auto n = static_cast<std::uint32_t>(table.buildingCount());
  std::vector<std::vector<double>> squared(n, std::vector<double>(n, 0));
  const auto has = [&](std::uint32_t b) { return table.buildingRing[b] != table.buildingRing[b + 1]; };
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = a + 1; b < n; ++b) {
      if (!has(a) || !has(b)) continue;
      squared[a][b] = squared[b][a] = options.distance == FootprintDistance::Vertex
                                          ? vertexDistanceSquared(table, a, b)
                                          : closestPoints(table, a, b, FootprintDistance::Outline).squared;
    }
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t a = 0; a < n; ++a) {
    std::vector<std::pair<double, std::uint32_t>> others;
    for (std::uint32_t b = 0; b < n; ++b) {
      if (a != b && has(a) && has(b)) others.emplace_back(squared[a][b], b);
    }
    std::sort(others.begin(), others.end());
    others.resize(std::min<std::size_t>(others.size(), static_cast<std::size_t>(options.neighbours)));
    for (const auto& [d, b] : others) pairs.insert(std::minmax(a, b));
  }
  std::vector<std::uint32_t> buildingOf;
  for (std::uint32_t b = 0; b < n; ++b) {
    const std::uint32_t end = table.ringStart[table.buildingRing[b + 1]];
    while (buildingOf.size() < end) buildingOf.push_back(b);
  }
  for (const auto& [u, v] : referenceSpanningTree(table.vertices)) {
    if (buildingOf[u] != buildingOf[v]) pairs.insert(std::minmax(buildingOf[u], buildingOf[v]));
  }
  ReferenceGraph graph;
  for (const auto& [a, b] : pairs) graph[{a, b}] = cost(a, b, std::sqrt(squared[a][b]));
  return graph;
}

/// The greedy algorithm as the paper writes it: at every step Eq. (1) is computed anew for all pairs of
/// clusters, with the average cluster size of that step, and the cheapest pair is joined; ties by (size·size,
/// smaller, larger smallest leaf). `bySize` false: plain single-link. Forbidden pairs wait until there are no
/// others. O(n · E).
inline std::vector<Merge> referenceMerges(const FootprintTable& table, const ReferenceGraph& leaves,
                                          bool bySize = true) {
  struct Cluster {
    NodeId node;
    std::uint32_t size;
  };
  const auto n = static_cast<std::uint32_t>(table.buildingCount());
  std::map<std::uint32_t, Cluster> clusters;  // by smallest leaf
  for (std::uint32_t i = 0; i < n; ++i) clusters[i] = {i, 1};
  ReferenceGraph graph = leaves;
  std::vector<Merge> merges;
  double sizes = 0;
  double greatest = 0;
  while (!graph.empty()) {
    const double average = merges.empty() ? 1 : sizes / static_cast<double>(merges.size());
    const auto keyOf = [&](const ReferenceGraph::value_type& edge) {
      const double product = static_cast<double>(clusters.at(edge.first.first).size) *
                             static_cast<double>(clusters.at(edge.first.second).size);
      const double weight = bySize ? product * edge.second.distance : edge.second.distance;
      return std::tuple(edge.second.forbidden, weight / (average * average), weight, product,
                        edge.first.first, edge.first.second);
    };
    const auto best = std::min_element(graph.begin(), graph.end(),
                                       [&](const auto& a, const auto& b) { return keyOf(a) < keyOf(b); });
    const auto [forbidden, cost, weight, product, low, high] = keyOf(*best);
    greatest = std::max(greatest, weight);
    const double recorded = forbidden ? greatest : weight;
    Merge merge{clusters.at(low).node,          clusters.at(high).node,
                best->second.distance,          recorded,
                recorded / (average * average), clusters.at(low).size + clusters.at(high).size};
    clusters.at(low) = {n + static_cast<std::uint32_t>(merges.size()), merge.size};
    clusters.erase(high);
    merges.push_back(merge);
    sizes += merge.size;
    ReferenceGraph next;
    for (const auto& [ends, pair] : graph) {
      std::pair<std::uint32_t, std::uint32_t> moved = ends;
      if (moved.first == high) moved.first = low;
      if (moved.second == high) moved.second = low;
      if (moved.first == moved.second) continue;
      if (moved.first > moved.second) std::swap(moved.first, moved.second);
      const auto [at, added] = next.emplace(moved, pair);
      if (!added &&
          std::tuple(pair.forbidden, pair.distance) < std::tuple(at->second.forbidden, at->second.distance)) {
        at->second = pair;
      }
    }
    graph = std::move(next);
  }
  return merges;
}

inline ReferencePair plainCost(std::uint32_t, std::uint32_t, double distance) {
  return {distance, false};
}

}  // namespace lodestone::test
