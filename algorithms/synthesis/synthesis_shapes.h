// Lattices and building outlines of made-up cities.
#pragma once

#include <cstdint>

#include "algorithms/synthesis/synthesis_random.h"
#include "model/geometry.h"

namespace lodestone {

/// A square lattice turned by a Pythagorean triple (p, q, c) with p² + q² = c². Its points fall on multiples
/// of 1/8 m, which doubles and millimetres both hold exactly: walls that touch in the plan touch in the
/// numbers too, whatever the direction of the streets.
struct Lattice {
  static constexpr int kUnitsPerMetre = 8;
  std::int64_t originX = 0;  ///< eighths of a metre
  std::int64_t originY = 0;
  int p = 1;
  int q = 0;
  int c = 1;  ///< one step is c/8 m long

  [[nodiscard]] Vec2 world(std::int64_t a, std::int64_t b) const {
    return {static_cast<double>(originX + p * a - q * b) / kUnitsPerMetre,
            static_cast<double>(originY + q * a + p * b) / kUnitsPerMetre};
  }
  /// Whole steps nearest to a length, at least one.
  [[nodiscard]] int steps(double metres) const {
    const int n = static_cast<int>(metres * kUnitsPerMetre / c + 0.5);
    return n < 1 ? 1 : n;
  }
  /// A length between two, in steps.
  [[nodiscard]] int between(SynthRandom& random, double low, double high) const {
    return random.between(steps(low), steps(high));
  }
};

/// Rectangle of lattice points, a along the streets, b across.
struct LatticeRect {
  std::int64_t a0 = 0, b0 = 0, a1 = 0, b1 = 0;
  [[nodiscard]] int width() const { return static_cast<int>(a1 - a0); }
  [[nodiscard]] int depth() const { return static_cast<int>(b1 - b0); }
};

/// A lot against a street: the front wall stands on b = `front`, the building reaches to b + depth (`away` =
/// 1) or b − depth (`away` = −1).
struct Frontage {
  std::int64_t a = 0;
  std::int64_t front = 0;
  int away = 1;
  int width = 0;  ///< steps
};

/// Steps (pairs of vertices beyond the rectangle's four) that an outline of this width has room for.
[[nodiscard]] int mostSteps(int width);

/// Outline with `jogs` jogs in its rear wall: a rectangle (0), an L (1), a T, U or Z (2), or a stepped house.
/// Depths lie in [depth/2, depth]. Has 4 + 2·jogs vertices, none of them collinear with its neighbours;
/// counter-clockwise. \pre jogs ≤ mostSteps(lot.width), depth ≥ 2
[[nodiscard]] Ring steppedOutline(const Lattice& lattice, const Frontage& lot, int depth, int jogs,
                                  SynthRandom& random);

[[nodiscard]] Ring rectangle(const Lattice& lattice, const LatticeRect& rect);

}  // namespace lodestone
