// Random rings and polygons for property tests, the same for a seed on every machine.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "model/geometry.h"

namespace lodestone::test {

/// Numbers that do not depend on the standard library's distributions.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }

 private:
  std::mt19937 engine_;
};

/// A star-shaped ring about a centre: simple, counter-clockwise, usually concave. Coordinates are rounded to
/// multiples of `grid` when that is positive, which can make it touch or cross itself.
inline Ring randomStar(Random& random, const Vec2& centre, double radius, int vertices, double grid = 0) {
  Ring ring;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.real(0.1, 0.9)) / vertices;
    const double r = radius * random.real(0.3, 1);
    Vec2 p = centre + r * Vec2(std::cos(angle), std::sin(angle));
    if (grid > 0) p = (p / grid).array().round() * grid;
    ring.push_back(p);
  }
  return ring;
}

/// An axis-aligned rectangle or L on whole numbers: such shapes touch, coincide and line up with each other.
inline Ring randomGridHouse(Random& random, int extent) {
  const double x = random.integer(0, extent);
  const double y = random.integer(0, extent);
  const double w = random.integer(1, 4);
  const double h = random.integer(1, 4);
  Ring ring{Vec2(x, y), Vec2(x + w, y), Vec2(x + w, y + h)};
  if (w > 1 && h > 1 && random.integer(0, 1) == 1) {
    ring.insert(ring.end(), {Vec2(x + 1, y + h), Vec2(x + 1, y + 1), Vec2(x, y + 1)});
  } else {
    if (random.integer(0, 2) == 0) ring.push_back(Vec2(x + w / 2, y + h));  // collinear
    ring.push_back(Vec2(x, y + h));
  }
  return ring;
}

}  // namespace lodestone::test
