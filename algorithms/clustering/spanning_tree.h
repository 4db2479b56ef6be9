// The Euclidean minimum spanning tree of points in the plane.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry.h"
#include "model/progress.h"

namespace lodestone {

/// An edge between points a < b, with its squared length in square metres.
struct SpanningEdge {
  double squared = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  bool operator==(const SpanningEdge&) const = default;
  /// The total order that makes the tree unique: squared length in double precision, then a, then b.
  bool operator<(const SpanningEdge& other) const {
    if (squared != other.squared) return squared < other.squared;
    return a != other.a ? a < other.a : b < other.b;
  }
};

/// The n − 1 edges of the minimum spanning tree, shortest first; points may coincide. Every edge of it is in
/// every Delaunay triangulation (the circle over it as diameter holds no other point), so it is found among
/// the edges of one, exactly (CGAL). Cost: O(n log n), parallel but for the last pass of Kruskal's algorithm.
/// Incomplete when a stop was requested.
[[nodiscard]] std::vector<SpanningEdge> spanningTree(std::span<const Vec2> points,
                                                     const Progress& progress = {});

}  // namespace lodestone
