// Points, boxes, rings and polygons. Coordinates are metres in double precision, relative to
// CityModel::origin, z up. Rings do not repeat their first vertex; outer rings are counter-clockwise seen
// from above, holes clockwise.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace lodestone {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;

/// Axis-aligned box; empty until the first point is added.
template <int Dim>
struct Box {
  using Point = Eigen::Matrix<double, Dim, 1>;
  Point min = Point::Constant(std::numeric_limits<double>::infinity());
  Point max = Point::Constant(-std::numeric_limits<double>::infinity());

  [[nodiscard]] bool empty() const { return (min.array() > max.array()).any(); }
  void add(const Point& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  void add(const Box& other) {
    min = min.cwiseMin(other.min);
    max = max.cwiseMax(other.max);
  }
  [[nodiscard]] Point center() const { return (min + max) / 2; }
  [[nodiscard]] Point size() const { return empty() ? Point::Zero().eval() : (max - min).eval(); }
  [[nodiscard]] bool contains(const Point& p) const {
    return (p.array() >= min.array()).all() && (p.array() <= max.array()).all();
  }
};
using Box2 = Box<2>;
using Box3 = Box<3>;

using Ring = std::vector<Vec2>;

/// One outer ring and its holes.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};
using MultiPolygon = std::vector<Polygon>;

/// Signed area of a ring (shoelace, taken about the first vertex so that large coordinates cost no digits);
/// positive when counter-clockwise.
[[nodiscard]] double signedArea(std::span<const Vec2> ring);
[[nodiscard]] inline double signedArea(const Ring& ring) { return signedArea(std::span<const Vec2>(ring)); }
/// Area of a polygon without its holes. \pre rings are simple.
[[nodiscard]] double area(const Polygon& polygon);
[[nodiscard]] double area(const MultiPolygon& polygons);
[[nodiscard]] Box2 bounds(const Ring& ring);
[[nodiscard]] Box2 bounds(const MultiPolygon& polygons);
/// Removes repeated vertices, closing vertex included, and turns the ring to the wanted orientation.
void tidyRing(Ring& ring, bool counterClockwise);

}  // namespace lodestone
