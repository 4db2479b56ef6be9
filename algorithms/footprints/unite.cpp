#include <algorithm>
#include <optional>

#include "algorithms/footprints/footprints.h"
#include "algorithms/geometry/close_segments.h"
#include "algorithms/geometry/exact_cover.h"
#include "algorithms/geometry/predicates.h"
#include "algorithms/geometry/ring_linking.h"

namespace lodestone {
namespace {

template <class Visit>
void forEachRing(const Polygon& polygon, const Visit& visit) {
  visit(polygon.outer);
  for (const Ring& hole : polygon.holes) visit(hole);
}

std::vector<Ring> ringsOf(const MultiPolygon& polygons) {
  std::vector<Ring> rings;
  for (const Polygon& polygon : polygons)
    forEachRing(polygon, [&](const Ring& ring) { rings.push_back(ring); });
  return rings;
}

/// Points and directed edges of rings, equal points numbered once.
struct EdgeSet {
  std::vector<Vec2> points;
  std::vector<DirectedEdge> edges;

  explicit EdgeSet(const std::vector<Ring>& rings) {
    for (const Ring& ring : rings) points.insert(points.end(), ring.begin(), ring.end());
    std::sort(points.begin(), points.end(), lexicographicallyLess);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const auto numberOf = [&](const Vec2& p) {
      return static_cast<std::uint32_t>(
          std::lower_bound(points.begin(), points.end(), p, lexicographicallyLess) - points.begin());
    };
    for (const Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        edges.push_back({numberOf(ring[i]), numberOf(ring[(i + 1) % ring.size()])});
    }
    std::sort(edges.begin(), edges.end());
  }

  /// Removes edges that run both ways. False when an edge runs twice the same way: then the polygons overlap.
  bool cancel() {
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
    std::vector<DirectedEdge> left;
    for (const DirectedEdge& edge : edges) {
      if (!std::binary_search(edges.begin(), edges.end(), DirectedEdge{edge[1], edge[0]}))
        left.push_back(edge);
    }
    edges = std::move(left);
    return true;
  }

  /// True when every vertex starts one edge at most and edges meet only in their ends.
  [[nodiscard]] bool apart() const {
    for (std::size_t i = 1; i < edges.size(); ++i) {
      if (edges[i][0] == edges[i - 1][0]) return false;
    }
    bool clear = true;
    const auto segment = [&](std::size_t i) { return std::pair(points[edges[i][0]], points[edges[i][1]]); };
    forCloseSegments(edges.size(), segment, [&](std::size_t i, std::size_t j) {
      const auto [a, b] = segment(i);
      const auto [c, d] = segment(j);
      clear = contact(a, b, c, d) != Contact::Inside;
      return clear;
    });
    return clear;
  }
};

/// True when outer rings lie outside all others and holes directly inside one: \pre rings do not touch.
bool nestedOnce(const MultiPolygon& polygons) {
  const std::vector<Ring> rings = ringsOf(polygons);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    int winding = 0;
    for (std::size_t j = 0; j < rings.size(); ++j) {
      if (i != j && sideOf(rings[j], rings[i][0]) != Side::Outside)
        winding += signedArea(rings[j]) > 0 ? 1 : -1;
    }
    if (winding != (signedArea(rings[i]) > 0 ? 0 : 1)) return false;
  }
  return true;
}

/// The union where all that polygons share are whole edges.
std::optional<MultiPolygon> uniteBySharedEdges(const MultiPolygon& polygons) {
  EdgeSet set(ringsOf(polygons));
  if (!set.cancel() || !set.apart()) return std::nullopt;
  MultiPolygon result = linkRings(set.points, set.edges);
  if (!nestedOnce(result)) return std::nullopt;
  return result;
}

bool allValid(const MultiPolygon& polygons) {
  return std::all_of(polygons.begin(), polygons.end(), isValid);
}

/// cover(), again where rounding the crossings made rings meet.
MultiPolygon validCover(std::vector<Ring> rings, CoverRule rule) {
  constexpr int kRounds = 4;
  MultiPolygon result = cover(rings, rule);
  for (int round = 1; round < kRounds && !allValid(result); ++round) result = cover(ringsOf(result), rule);
  return result;
}

}  // namespace

MultiPolygon repaired(const Polygon& polygon) {
  Polygon clean;
  clean.outer = polygon.outer;
  tidyRing(clean.outer, true);
  if (clean.outer.size() < 3) return {};
  for (Ring hole : polygon.holes) {
    tidyRing(hole, false);
    if (hole.size() >= 3) clean.holes.push_back(std::move(hole));
  }
  if (isValid(clean)) return {std::move(clean)};
  return validCover(ringsOf({clean}), CoverRule::EvenOdd);
}

MultiPolygon unite(const MultiPolygon& polygons) {
  MultiPolygon valid;
  for (const Polygon& polygon : polygons) {
    for (Polygon& part : repaired(polygon)) valid.push_back(std::move(part));
  }
  if (valid.empty()) return {};
  if (std::optional<MultiPolygon> united = uniteBySharedEdges(valid)) return *std::move(united);
  return validCover(ringsOf(valid), CoverRule::Positive);
}

}  // namespace lodestone
