#include "algorithms/simplification/perceptual_cost.h"

#include <cmath>

#include <Eigen/Geometry>

namespace lodestone {
namespace {

/// Of the squared diagonal: what triangles back to back leave of their area vectors.
constexpr double kNoise = 1e-9;

}  // namespace

Vec3 PerceptualCost::Vertex::normal(const Vec3& at) const {
  const Vec3 sum = round - at.cross(opening);
  return sum.norm() > kNoise * box.size().squaredNorm() ? Vec3(sum.normalized()) : Vec3(Vec3::Zero());
}

PerceptualCost::PerceptualCost(const CollapsingMesh& mesh, std::uint32_t vertices, const Vec3& origin)
    : mesh_(mesh), origin_(origin), vertices_(vertices) {
  for (std::uint32_t v = 0; v < vertices; ++v) renew(v);
}

void PerceptualCost::renew(std::uint32_t v) {
  Vertex vertex;
  const Vec3 at = relative(v);
  vertex.box.add(at);
  mesh_.forEachTriangle(v, [&](std::uint32_t second, std::uint32_t third) {
    const Vec3 from = relative(second);
    const Vec3 to = relative(third);
    vertex.add(from, to);
    vertex.box.add(from);
    vertex.box.add(to);
  });
  vertex.brightness = lights_.brightness(vertex.normal(at));
  vertices_[v] = vertex;
}

PerceptualTerms PerceptualCost::operator()(std::uint32_t edge, const Vec3& at, double qem) const {
  const auto [v1, v2] = mesh_.ends(edge);
  Vertex both = vertices_[v1];
  both.round += vertices_[v2].round;
  both.opening += vertices_[v2].opening;
  const auto leave = [&, v1 = v1, v2 = v2](std::uint32_t second, std::uint32_t third) {
    both.add(relative(third), relative(second));
    if (second == v2)
      both.add(relative(v1), relative(third));
    else
      both.add(relative(second), relative(v1));
  };
  mesh_.forEachTriangleAtEdge(v1, v2, edge, leave);
  both.box.add(vertices_[v2].box);
  const double i1 = vertices_[v1].brightness;
  const double i2 = vertices_[v2].brightness;
  const double after = lights_.brightness(both.normal(at - origin_));
  const double diagonal = both.box.size().norm();
  return {std::abs((i1 + i2) / (i1 * i2) * after - 2), diagonal > 0 ? qem / diagonal : 0};
}

}  // namespace lodestone
