// Distances between triangles, segments and points in space.
#pragma once

#include <array>

#include "model/geometry.h"

namespace lodestone {

using TriangleCorners = std::array<Vec3, 3>;

/// Point of the closed triangle that is closest to p. Triangles without area are taken as their edges.
[[nodiscard]] Vec3 closestPoint(const TriangleCorners& triangle, const Vec3& p);
/// Squared distance of two closed segments.
[[nodiscard]] double squaredDistance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Squared distance of two closed triangles; 0 where they cross.
[[nodiscard]] double squaredDistance(const TriangleCorners& s, const TriangleCorners& t);

}  // namespace lodestone
