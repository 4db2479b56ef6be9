// The merged hull of rings: the greedy division of their convex hull (Chang et al. 2008, section 6).
#pragma once

#include <span>
#include <vector>

#include "algorithms/merging/hull_rings.h"
#include "algorithms/merging/hull_search.h"

namespace lodestone {

/// Makes merged hulls, one after another, in memory that is kept. One object a thread.
///
/// Of each present edge the largest open division (see HullSearch) is a candidate; the largest candidate that
/// does not pass the target is carried out. Divisions never become open by others, so a candidate is looked
/// at again only when its turn comes. Vertices of the rings that lie on a new edge become vertices of the
/// hull at once; in the middle of a straight side they are not counted as edges. Cost: O(n log n) for n
/// vertices in all but contrived cases.
class MergedHull {
 public:
  MergedHull() : search_(rings_, hull_) {}
  MergedHull(const MergedHull&) = delete;
  MergedHull& operator=(const MergedHull&) = delete;

  /// The hull, counter-clockwise from its smallest vertex, without vertices in the middle of straight sides.
  /// Empty when the rings have no area. Valid until the next call. \pre `simple`: all rings are simple and
  /// counter-clockwise; without it the search is slower.
  [[nodiscard]] std::span<const Vec2> make(std::span<const std::span<const Vec2>> rings,
                                           std::size_t targetEdges, bool simple);

 private:
  bool startFromConvexHull();
  void divideUntil(std::size_t target);
  void divide(const Division& division);
  void link(VertexId from, VertexId to, std::vector<VertexId>& between);
  void consider(VertexId a);
  void push(const Division& division);
  [[nodiscard]] bool isCorner(VertexId before, VertexId v, VertexId after) const;
  [[nodiscard]] int edgesAdded(const Division& division) const;
  void collect();

  HullRings rings_;
  HullState hull_;
  HullSearch search_;
  std::vector<VertexId> previous_;  ///< clockwise neighbour of vertices on the hull
  VertexId start_ = kNoVertex;      ///< smallest vertex: always on the hull
  std::size_t edges_ = 0;           ///< corners of the hull
  std::vector<VertexId> convex_;
  std::vector<Division> candidates_;  ///< heap
  std::vector<Division> passedOver_;
  std::vector<Vec2> result_;
};

}  // namespace lodestone
