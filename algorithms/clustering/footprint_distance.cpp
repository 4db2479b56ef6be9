#include "algorithms/clustering/footprint_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/clustering/packed_footprints.h"

namespace lodestone {
namespace {

// Boxes of single walls leave out pairs that are further than the best so far by more than any rounding.
constexpr double kRoundingMargin = 1 + 1e-9;

struct Segment {
  Vec2 a, b;
};

/// Rings [begin, end) of rings stored flat.
struct Rings {
  const Vec2* vertices;
  const std::uint32_t* ringStart;
  std::uint32_t begin, end;

  template <class Visit>
  void forEachRing(Visit&& visit) const {
    for (std::uint32_t r = begin; r < end; ++r) {
      visit(std::span<const Vec2>(vertices + ringStart[r], vertices + ringStart[r + 1]));
    }
  }
  template <class Visit>
  void forEachSegment(Visit&& visit) const {
    forEachRing([&](std::span<const Vec2> ring) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        visit(Segment{ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]});
    });
  }
  template <class Visit>
  void forEachVertex(Visit&& visit) const {
    forEachRing([&](std::span<const Vec2> ring) {
      for (const Vec2& vertex : ring) visit(vertex);
    });
  }
};

Rings ringsOf(const FootprintTable& table, std::uint32_t building) {
  return {table.vertices.data(), table.ringStart.data(), table.buildingRing[building],
          table.buildingRing[building + 1]};
}

double squaredLength(const Vec2& v) {
  return v.x() * v.x() + v.y() * v.y();
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

Vec2 closestOn(const Segment& s, const Vec2& p) {
  const Vec2 along = s.b - s.a;
  const double length = squaredLength(along);
  if (length == 0) return s.a;
  const double t = ((p.x() - s.a.x()) * along.x() + (p.y() - s.a.y()) * along.y()) / length;
  if (t <= 0) return s.a;
  if (t >= 1) return s.b;
  return s.a + t * along;
}

bool cross(const Segment& s, const Segment& t) {
  const double a = turn(s.a, s.b, t.a);
  const double b = turn(s.a, s.b, t.b);
  const double c = turn(t.a, t.b, s.a);
  const double d = turn(t.a, t.b, s.b);
  return ((a < 0 && b > 0) || (a > 0 && b < 0)) && ((c < 0 && d > 0) || (c > 0 && d < 0));
}

void take(ClosestPoints& best, const Vec2& onFirst, const Vec2& onSecond) {
  const double squared = squaredLength(onFirst - onSecond);
  if (squared < best.squared) best = {squared, onFirst, onSecond};
}

void measure(ClosestPoints& best, const Segment& s, const Segment& t) {
  if (cross(s, t)) {
    best = {0, s.a, s.a};
    return;
  }
  take(best, s.a, closestOn(t, s.a));
  take(best, s.b, closestOn(t, s.b));
  take(best, closestOn(s, t.a), t.a);
  take(best, closestOn(s, t.b), t.b);
}

Box2 boxOf(const Segment& s) {
  Box2 box;
  box.add(s.a);
  box.add(s.b);
  return box;
}

Box2 boxOf(const Rings& rings) {
  Box2 box;
  rings.forEachVertex([&](const Vec2& v) { box.add(v); });
  return box;
}

/// Even-odd rule over all rings, so that a courtyard is outside.
bool contains(const Rings& rings, const Vec2& p) {
  bool inside = false;
  rings.forEachSegment([&](const Segment& s) {
    if ((s.a.y() > p.y()) == (s.b.y() > p.y())) return;
    const double side = turn(s.a, s.b, p);
    if (s.b.y() > s.a.y() ? side > 0 : side < 0) inside = !inside;
  });
  return inside;
}

/// \pre the outlines do not cross: each ring lies inside or outside as a whole.
bool lieInEachOther(const Rings& a, const Rings& b) {
  bool inside = false;
  a.forEachRing([&](std::span<const Vec2> ring) { inside = inside || contains(b, ring.front()); });
  b.forEachRing([&](std::span<const Vec2> ring) { inside = inside || contains(a, ring.front()); });
  return inside;
}

ClosestPoints closestVertices(const Rings& a, const Rings& b) {
  ClosestPoints best;
  a.forEachVertex([&](const Vec2& p) { b.forEachVertex([&](const Vec2& q) { take(best, p, q); }); });
  return best;
}

ClosestPoints closestOutlinePoints(const Rings& a, const Rings& b, double limit) {
  const Box2 boxA = boxOf(a);
  const Box2 boxB = boxOf(b);
  const double apart = squaredDistance(boxA, boxB);
  ClosestPoints best;
  if (apart > limit) return best;
  const auto hopeless = [&](double squared) {
    return squared > std::min(best.squared, limit) * kRoundingMargin;
  };
  a.forEachSegment([&](const Segment& s) {
    const Box2 boxS = boxOf(s);
    if (best.squared == 0 || hopeless(squaredDistance(boxS, boxB))) return;
    b.forEachSegment([&](const Segment& t) {
      if (best.squared > 0 && !hopeless(squaredDistance(boxS, boxOf(t)))) measure(best, s, t);
    });
  });
  if (apart == 0 && best.squared > 0 && lieInEachOther(a, b)) best.squared = 0;
  // Rounding in closestOn() must not bring two footprints nearer than their boxes, by which searches leave
  // pairs out.
  best.squared = std::max(best.squared, apart);
  return best;
}

}  // namespace

ClosestPoints closestPoints(const FootprintTable& footprints, std::uint32_t a, std::uint32_t b,
                            FootprintDistance distance, double limit) {
  const Rings first = ringsOf(footprints, std::min(a, b));
  const Rings second = ringsOf(footprints, std::max(a, b));
  return distance == FootprintDistance::Vertex ? closestVertices(first, second)
                                               : closestOutlinePoints(first, second, limit);
}

double gapBetween(std::span<const Vec2> a, std::span<const Vec2> b) {
  if (a.empty() || b.empty()) return 0;
  const std::array<std::uint32_t, 2> ringOfA{0, static_cast<std::uint32_t>(a.size())};
  const std::array<std::uint32_t, 2> ringOfB{0, static_cast<std::uint32_t>(b.size())};
  const ClosestPoints closest =
      closestOutlinePoints({a.data(), ringOfA.data(), 0, 1}, {b.data(), ringOfB.data(), 0, 1},
                           std::numeric_limits<double>::infinity());
  return std::sqrt(closest.squared);
}

}  // namespace lodestone
