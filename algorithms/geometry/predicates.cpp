#include "algorithms/geometry/predicates.h"

#include <algorithm>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "algorithms/geometry/close_segments.h"

namespace lodestone {

int exactOrientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [](const Vec2& p) { return Kernel::Point_2(p.x(), p.y()); };
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c)));
}

namespace {

bool inBoxOf(const Vec2& a, const Vec2& b, const Vec2& q) {
  return (q.array() >= a.cwiseMin(b).array()).all() && (q.array() <= a.cwiseMax(b).array()).all();
}

/// Contact of two collinear segments.
Contact collinearContact(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto ordered = [](Vec2 p, Vec2 q) {
    return lexicographicallyLess(q, p) ? std::pair(q, p) : std::pair(p, q);
  };
  const auto [a0, b0] = ordered(a, b);
  const auto [c0, d0] = ordered(c, d);
  if (lexicographicallyLess(b0, c0) || lexicographicallyLess(d0, a0)) return Contact::None;
  return b0 == c0 || d0 == a0 ? Contact::Ends : Contact::Inside;
}

}  // namespace

bool onSegment(const Vec2& a, const Vec2& b, const Vec2& q) {
  return inBoxOf(a, b, q) && orientation(a, b, q) == 0;
}

Contact contact(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const int abc = orientation(a, b, c);
  const int abd = orientation(a, b, d);
  if (abc * abd > 0) return Contact::None;
  const int cda = orientation(c, d, a);
  const int cdb = orientation(c, d, b);
  if (cda * cdb > 0) return Contact::None;
  if (abc == 0 && abd == 0) return collinearContact(a, b, c, d);
  return a == c || a == d || b == c || b == d ? Contact::Ends : Contact::Inside;
}

Side sideOf(const Ring& ring, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    if (onSegment(a, b, point)) return Side::Boundary;
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const int turn = orientation(
        a, b,
        point);  // the edge spans the point's height: left of an upward edge, it is hit by the ray to +x
    if ((b.y() > a.y()) == (turn > 0)) inside = !inside;
  }
  return inside ? Side::Inside : Side::Outside;
}

bool isSimple(const Ring& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  const auto next = [n](std::size_t i) { return i + 1 == n ? 0 : i + 1; };
  bool simple = true;
  forCloseSegments(
      n, [&](std::size_t i) { return std::pair(ring[i], ring[next(i)]); },
      [&](std::size_t i, std::size_t j) {
        const Contact met = contact(ring[i], ring[next(i)], ring[j], ring[next(j)]);
        const bool neighbours = next(i) == j || next(j) == i;
        simple = neighbours ? met == Contact::Ends : met == Contact::None;
        return simple;
      });
  return simple;
}

namespace {

/// True when the rings share more than vertices.
bool ringsCross(const Ring& a, const Ring& b) {
  bool cross = false;
  const auto segment = [&](std::size_t i) {
    const Ring& ring = i < a.size() ? a : b;
    const std::size_t k = i < a.size() ? i : i - a.size();
    return std::pair(ring[k], ring[(k + 1) % ring.size()]);
  };
  forCloseSegments(a.size() + b.size(), segment, [&](std::size_t i, std::size_t j) {
    if ((i < a.size()) == (j < a.size())) return true;
    const auto [p, q] = segment(i);
    const auto [r, s] = segment(j);
    cross = contact(p, q, r, s) == Contact::Inside;
    return !cross;
  });
  return cross;
}

/// True when no vertex of `ring` is on the other side of `around` and at least one is on `side`.
bool lies(const Ring& ring, Side side, const Ring& around) {
  bool found = false;
  for (const Vec2& p : ring) {
    const Side at = sideOf(around, p);
    if (at != side && at != Side::Boundary) return false;
    found = found || at == side;
  }
  return found;
}

}  // namespace

bool isValid(const Polygon& polygon) {
  if (!isSimple(polygon.outer) || signedArea(polygon.outer) <= 0) return false;
  for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
    const Ring& hole = polygon.holes[h];
    if (!isSimple(hole) || signedArea(hole) >= 0) return false;
    if (ringsCross(polygon.outer, hole) || !lies(hole, Side::Inside, polygon.outer)) return false;
    for (std::size_t other = 0; other < h; ++other) {
      if (ringsCross(polygon.holes[other], hole) || !lies(hole, Side::Outside, polygon.holes[other]))
        return false;
    }
  }
  return true;
}

}  // namespace lodestone
