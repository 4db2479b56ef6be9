#include "algorithms/simplification/edge_contact.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace lodestone {
namespace {

/// A triangle with its unit normal, and how far a point lies from its edges in its plane.
struct Plane {
  const TriangleCorners& corners;
  Vec3 normal;

  [[nodiscard]] double height(const Vec3& p) const { return normal.dot(p - corners[0]); }
  /// Distance inwards of edge i, in metres.
  [[nodiscard]] double inward(const Vec3& p, std::size_t i) const {
    const Vec3 edge = corners[(i + 1) % 3] - corners[i];
    return normal.cross(edge).dot(p - corners[i]) / edge.norm();
  }
  [[nodiscard]] bool holds(const Vec3& p, double tolerance) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (inward(p, i) < -tolerance) return false;
    }
    return true;
  }
};

/// The part of the line p1 + s · (p2 − p1) that runs over the triangle, in s; empty where first > last.
struct Range {
  double first = 0;
  double last = -1;
};

Range clip(const Plane& plane, const Vec3& p1, const Vec3& p2, double from, double to, double tolerance) {
  Range range{from, to};
  for (std::size_t i = 0; i < 3; ++i) {
    const double at1 = plane.inward(p1, i) + tolerance;
    const double change = plane.inward(p2, i) + tolerance - at1;
    if (change == 0) {
      if (at1 < 0) return {};
      continue;
    }
    const double s = -at1 / change;
    if (change > 0)
      range.first = std::max(range.first, s);
    else
      range.last = std::min(range.last, s);
  }
  return range;
}

EdgeContact coplanarContact(const Plane& plane, const Vec3& p1, const Vec3& p2, double gap,
                            double tolerance) {
  EdgeContact contact;
  contact.touches1 = plane.holds(p1, tolerance);
  contact.touches2 = plane.holds(p2, tolerance);
  if (!contact.touches1 && !contact.touches2) {
    const Range range = clip(plane, p1, p2, -gap, 1 + gap, tolerance);
    if (range.first > range.last) return contact;
    contact.overlaps = range.first <= 1 && range.last >= 0;
    contact.reaches1 = range.last < 0;
    contact.reaches2 = range.first > 1;
  }
  contact.meets = true;
  return contact;
}

/// Surely nothing in common, told without a square root: most pairs that are asked about. `normal` is not
/// unit.
bool farFromPlane(const Vec3& p1, const Vec3& p2, const Vec3& corner, const Vec3& normal, double gap,
                  double tolerance) {
  constexpr double kMargin = 1.001;  // the exact answer decides what is close
  const double r1 = normal.dot(p1 - corner);
  const double r2 = normal.dot(p2 - corner);
  if (!(r1 * r2 > 0)) return false;
  const double low = std::min(std::abs(r1), std::abs(r2));
  const double high = std::max(std::abs(r1), std::abs(r2));
  return low > kMargin * gap * (high - low) &&
         low * low > kMargin * tolerance * tolerance * normal.squaredNorm();
}

}  // namespace

EdgeContact edgeContact(const Vec3& p1, const Vec3& p2, const TriangleCorners& triangle, double gap,
                        double tolerance) {
  EdgeContact contact;
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  if (farFromPlane(p1, p2, triangle[0], normal, gap, tolerance)) return contact;
  const double area = normal.norm();
  const double length = (p2 - p1).norm();
  if (area == 0 || length == 0) return contact;
  const Plane plane{triangle, normal / area};
  const double h1 = plane.height(p1);
  const double h2 = plane.height(p2);
  if (std::abs(h1) <= tolerance && std::abs(h2) <= tolerance)
    return coplanarContact(plane, p1, p2, gap, tolerance);
  if (h1 == h2) return contact;
  const double s = h1 / (h1 - h2);
  const bool hit = s >= -gap && s <= 1 + gap && plane.holds(p1 + s * (p2 - p1), tolerance);
  // A flat edge goes through the plane far from an end that lies in it: the end itself is asked as well, and
  // a hit far from it is no touch.
  contact.touches1 = std::abs(h1) <= tolerance && ((hit && s <= gap) || plane.holds(p1, tolerance));
  contact.touches2 = std::abs(h2) <= tolerance && ((hit && s >= 1 - gap) || plane.holds(p2, tolerance));
  contact.meets = hit || contact.touches1 || contact.touches2;
  if (!hit || contact.touches1 || contact.touches2) return contact;
  contact.crosses = s > 0 && s < 1;
  contact.entersAt1 = contact.crosses && h2 > h1;
  contact.reaches1 = s <= 0;
  contact.reaches2 = s >= 1;
  return contact;
}

}  // namespace lodestone
