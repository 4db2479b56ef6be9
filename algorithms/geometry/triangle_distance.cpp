#include "algorithms/geometry/triangle_distance.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace lodestone {
namespace {

Vec3 closestOnSegment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  if (length == 0) return a;
  return a + std::clamp((p - a).dot(along) / length, 0.0, 1.0) * along;
}

Vec3 closestOnEdges(const TriangleCorners& t, const Vec3& p) {
  Vec3 best = t[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 candidate = closestOnSegment(t[i], t[(i + 1) % 3], p);
    const double squared = (candidate - p).squaredNorm();
    if (squared < least) {
      least = squared;
      best = candidate;
    }
  }
  return best;
}

/// Whether the closed segment crosses the inside of the triangle.
bool crosses(const Vec3& a, const Vec3& b, const TriangleCorners& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double da = normal.dot(a - t[0]);
  const double db = normal.dot(b - t[0]);
  if ((da > 0 && db > 0) || (da < 0 && db < 0) || da == db) return false;
  const Vec3 p = a + da / (da - db) * (b - a);
  for (std::size_t i = 0; i < 3; ++i) {
    if (normal.dot((t[(i + 1) % 3] - t[i]).cross(p - t[i])) < 0) return false;
  }
  return true;
}

}  // namespace

Vec3 closestPoint(const TriangleCorners& t, const Vec3& p) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double squared = normal.squaredNorm();
  if (squared > 0) {
    const Vec3 foot = p - normal * (normal.dot(p - t[0]) / squared);
    bool inside = true;
    for (std::size_t i = 0; i < 3 && inside; ++i)
      inside = normal.dot((t[(i + 1) % 3] - t[i]).cross(foot - t[i])) >= 0;
    if (inside) return foot;
  }
  return closestOnEdges(t, p);
}

double squaredDistance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  // Ericson, Real-Time Collision Detection (2005), section 5.1.9.
  const Vec3 u = b - a;
  const Vec3 v = d - c;
  const Vec3 w = a - c;
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  if (uu == 0) return (closestOnSegment(c, d, a) - a).squaredNorm();
  if (vv == 0) return (closestOnSegment(a, b, c) - c).squaredNorm();
  const double uv = u.dot(v);
  const double uw = u.dot(w);
  const double vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 1e-14 * uu * vv ? std::clamp((uv * vw - uw * vv) / determinant, 0.0, 1.0) : 0.0;
  double t = (uv * s + vw) / vv;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
  }
  return (w + s * u - t * v).squaredNorm();
}

double squaredDistance(const TriangleCorners& s, const TriangleCorners& t) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    if (crosses(s[i], s[(i + 1) % 3], t) || crosses(t[i], t[(i + 1) % 3], s)) return 0;
    least = std::min(
        {least, (closestPoint(t, s[i]) - s[i]).squaredNorm(), (closestPoint(s, t[i]) - t[i]).squaredNorm()});
    for (std::size_t j = 0; j < 3; ++j)
      least = std::min(least, squaredDistance(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3]));
  }
  return least;
}

}  // namespace lodestone
