// Exact geometric predicates in the plane: right for every input, fast where doubles decide.
#pragma once

#include <cmath>

#include "model/geometry.h"

namespace lodestone {

/// Orientation in exact arithmetic, for the few cases that doubles cannot decide.
[[nodiscard]] int exactOrientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// 1 when a, b, c turn left, −1 when they turn right, 0 when they are collinear. Exact.
/// The error bound is Shewchuk's (Adaptive Precision Floating-Point Arithmetic, 1997: ccwerrboundA).
[[nodiscard]] inline int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  constexpr double kBound = 3.3306690738754716e-16;
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double determinant = left - right;
  const double error = kBound * (std::abs(left) + std::abs(right));
  if (determinant > error) return 1;
  if (determinant < -error) return -1;
  if (a == b || a == c || b == c) return 0;  // by far the most frequent of the cases that are left
  return exactOrientation(a, b, c);
}

/// Lexicographic order, by x and then y.
[[nodiscard]] inline bool lexicographicallyLess(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

/// True when q lies on the closed segment from a to b.
[[nodiscard]] bool onSegment(const Vec2& a, const Vec2& b, const Vec2& q);

/// How two closed segments meet.
enum class Contact {
  None,    ///< no common point
  Ends,    ///< one common point, an end of both
  Inside,  ///< a common point that is not an end of both, or a common stretch
};
[[nodiscard]] Contact contact(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// Where a point lies to a ring, by the even-odd rule.
enum class Side { Outside, Boundary, Inside };
[[nodiscard]] Side sideOf(const Ring& ring, const Vec2& point);

/// True when no two edges of the ring meet but neighbours in their common vertex, and no vertex is repeated.
/// About O(n log n).
[[nodiscard]] bool isSimple(const Ring& ring);

/// True when all rings are simple and share vertices at most, the outer one is counter-clockwise, and each
/// hole is clockwise, inside it and outside the other holes.
[[nodiscard]] bool isValid(const Polygon& polygon);

}  // namespace lodestone
