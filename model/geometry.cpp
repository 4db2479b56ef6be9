#include "model/geometry.h"

#include <algorithm>

namespace lodestone {

double signedArea(std::span<const Vec2> ring) {
  double twice = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Vec2 a = ring[i - 1] - ring[0];
    const Vec2 b = ring[i] - ring[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

double area(const Polygon& polygon) {
  double sum = std::abs(signedArea(polygon.outer));
  for (const Ring& hole : polygon.holes) sum -= std::abs(signedArea(hole));
  return sum;
}

double area(const MultiPolygon& polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) sum += area(polygon);
  return sum;
}

Box2 bounds(const Ring& ring) {
  Box2 box;
  for (const Vec2& p : ring) box.add(p);
  return box;
}

Box2 bounds(const MultiPolygon& polygons) {
  Box2 box;
  for (const Polygon& polygon : polygons) box.add(bounds(polygon.outer));
  return box;
}

void tidyRing(Ring& ring, bool counterClockwise) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if ((signedArea(ring) > 0) != counterClockwise) std::reverse(ring.begin(), ring.end());
}

}  // namespace lodestone
