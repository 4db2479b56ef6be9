#include "gui/view3d/city_picker.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace lodestone {
namespace {

/// Distance at which the ray enters the box, or infinity when it misses.
double enters(const MeshBox& box, const Vec3& origin, const Vec3& inverse) {
  double first = 0;
  double last = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double a = (static_cast<double>(box.min[i]) - origin[axis]) * inverse[axis];
    const double b = (static_cast<double>(box.max[i]) - origin[axis]) * inverse[axis];
    // 0 · ∞ is NaN for a ray within a box's plane: std::min and std::max then keep the bound that was there.
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last ? first : std::numeric_limits<double>::infinity();
}

}  // namespace

std::array<Vec3, 3> triangleOf(const NodeMesh& mesh, std::size_t firstIndex) {
  std::array<Vec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const MeshVertex& v = mesh.vertices[mesh.indices[firstIndex + k]];
    corners[k] = mesh.anchor + Vec3(v.x, v.y, v.z);
  }
  return corners;
}

std::optional<double> intersect(const std::array<Vec3, 3>& triangle, const Vec3& origin,
                                const Vec3& direction) {
  const Vec3 a = triangle[1] - triangle[0];
  const Vec3 b = triangle[2] - triangle[0];
  const Vec3 p = direction.cross(b);
  const double determinant = a.dot(p);
  if (determinant == 0) return {};
  const Vec3 s = origin - triangle[0];
  const double u = s.dot(p) / determinant;
  if (u < 0 || u > 1) return {};
  const Vec3 q = s.cross(a);
  const double v = direction.dot(q) / determinant;
  if (v < 0 || u + v > 1) return {};
  const double t = b.dot(q) / determinant;
  if (t < 0) return {};
  return t;
}

std::optional<RayHit> castRay(const NodeMesh& mesh, std::span<const NodeId> nodes, const Vec3& origin,
                              const Vec3& direction) {
  const Vec3 from = origin - mesh.anchor;
  const Vec3 inverse = direction.cwiseInverse();
  std::vector<RayHit> entered;
  for (const NodeId node : nodes) {
    const double t = enters(mesh.boxes[node - mesh.firstNode], from, inverse);
    if (std::isfinite(t)) entered.push_back({node, t});
  }
  std::sort(entered.begin(), entered.end(),
            [](const RayHit& a, const RayHit& b) { return a.distance < b.distance; });
  std::optional<RayHit> best;
  for (const RayHit& candidate : entered) {
    if (best && candidate.distance > best->distance) break;  // all that follow begin behind what was hit
    const MeshRange& range = mesh.ranges[candidate.node - mesh.firstNode];
    for (std::uint32_t i = range.first; i < range.first + range.count; i += 3) {
      const auto t = intersect(triangleOf(mesh, i), origin, direction);
      if (t && (!best || *t < best->distance)) best = RayHit{candidate.node, *t};
    }
  }
  return best;
}

}  // namespace lodestone
