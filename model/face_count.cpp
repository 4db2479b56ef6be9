#include "model/face_count.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "model/city_model.h"
#include "model/exterior.h"

namespace lodestone {
namespace {

constexpr double kLevel = 0.01;    // metres
constexpr double kUpright = 0.02;  // sine of the angle to the vertical

class FaceCounter {
 public:
  explicit FaceCounter(const Geometry& geometry) : geometry_(geometry) {
    const auto labelled = [](const SurfaceInfo& s) { return s.type != SurfaceType::Unknown; };
    if (std::any_of(geometry.surfaces.begin(), geometry.surfaces.end(), labelled)) return;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const std::uint32_t v : geometry.ringVertices) {
      lowest = std::min(lowest, geometry.vertices[v].z());
      highest = std::max(highest, geometry.vertices[v].z());
    }
    if (highest - lowest > kLevel) groundBelow_ = lowest + kLevel;
  }

  [[nodiscard]] FaceCount count() const {
    FaceCount all;
    for (std::size_t s = 0; s < geometry_.surfaceCount(); ++s) all += face(s);
    return all;
  }

 private:
  [[nodiscard]] FaceCount face(std::size_t s) const {
    const std::uint32_t first = geometry_.surfaceStart[s];
    const std::uint32_t last = geometry_.surfaceStart[s + 1];
    const SurfaceType type = geometry_.surfaces[s].type;
    if (first == last || isInterior(type)) return {};
    const std::size_t corners = geometry_.ringStart[last] - geometry_.ringStart[first];
    if (corners < 3) return {};
    const std::size_t holes = last - first - 1;
    const std::size_t triangles = corners - 2 + 2 * holes;
    if (type == SurfaceType::Ground || liesOnTheGround(first)) return {0, triangles};
    const bool quad = corners == 4 && holes == 0 && isUpright(first);
    return {quad ? 1 : triangles, triangles};
  }

  [[nodiscard]] const Vec3& corner(std::uint32_t i) const {
    return geometry_.vertices[geometry_.ringVertices[i]];
  }
  [[nodiscard]] bool liesOnTheGround(std::uint32_t ring) const {
    for (std::uint32_t i = geometry_.ringStart[ring]; i < geometry_.ringStart[ring + 1]; ++i) {
      if (!(corner(i).z() <= groundBelow_)) return false;
    }
    return true;
  }
  /// By Newell's normal of a ring of four.
  [[nodiscard]] bool isUpright(std::uint32_t ring) const {
    const std::uint32_t begin = geometry_.ringStart[ring];
    const Vec3 normal = (corner(begin + 2) - corner(begin)).cross(corner(begin + 3) - corner(begin + 1));
    return std::abs(normal.z()) <= kUpright * normal.norm();
  }

  const Geometry& geometry_;
  double groundBelow_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

double share(const FaceCount& drawn, const FaceCount& all) {
  return all.polygons == 0 ? 1 : static_cast<double>(drawn.polygons) / static_cast<double>(all.polygons);
}

FaceCount facesOf(const Geometry& geometry) {
  return FaceCounter(geometry).count();
}

FaceCount facesOfBlock(const MultiPolygon& footprint) {
  FaceCount count;
  for (const Polygon& polygon : footprint) {
    std::size_t vertices = polygon.outer.size();
    for (const Ring& hole : polygon.holes) vertices += hole.size();
    if (vertices < 3) continue;
    const std::size_t roof = vertices - 2 + 2 * polygon.holes.size();
    count += {vertices + roof, 2 * vertices + 2 * roof};
  }
  return count;
}

}  // namespace lodestone
