#include "algorithms/collapse_cost.h"

#include <algorithm>

namespace lodestone {
namespace {

/// An edge that stands across its reference plane is never collapsed (methods.md, 2.3).
constexpr double kAcross = 1e-6;

}  // namespace

CollapseCost::CollapseCost(const ComponentMesh& mesh, const Classification* classes, double a)
    : mesh_(mesh),
      classes_(classes),
      a_(a),
      origin_(bounds(mesh).center()),
      quadrics_(mesh.vertices.size()),
      areas_(mesh.vertices.size(), 0) {
  for (const ComponentMesh::Triangle& triangle : mesh.triangles) add(triangle);
  if (!classes_) return;
  for (const ComponentMesh::Triangle& triangle : classes_->fill) add(triangle);
  planeNormals_.reserve(classes_->planes.size());
  planeComponents_.reserve(classes_->planes.size());
  for (const std::uint32_t plane : classes_->planes) {
    planeNormals_.push_back(areaNormal(mesh, plane).normalized());
    planeComponents_.push_back(componentOfTriangle(mesh, plane));
  }
}

void CollapseCost::add(const ComponentMesh::Triangle& triangle) {
  const Vec3& a = mesh_.vertices[triangle[0]];
  const Vec3 normal = (mesh_.vertices[triangle[1]] - a).cross(mesh_.vertices[triangle[2]] - a);
  const Quadric quadric(normal, a - origin_);
  for (const std::uint32_t vertex : triangle) {
    quadrics_[vertex] += quadric;
    areas_[vertex] += normal.norm() / 2;
  }
}

double CollapseCost::leastCosine(std::uint32_t v1, std::uint32_t v2) const {
  const Vec3 direction = (mesh_.vertices[v2] - mesh_.vertices[v1]).normalized();
  const std::uint32_t begin2 = classes_->planeStart[v2];
  const std::uint32_t end2 = classes_->planeStart[v2 + 1];
  double least = 1;
  for (std::uint32_t i = classes_->planeStart[v1]; i < classes_->planeStart[v1 + 1]; ++i) {
    const auto shared = [&](std::uint32_t component) {
      for (std::uint32_t j = begin2; j < end2; ++j) {
        if (planeComponents_[j] == component) return true;
      }
      return false;
    };
    const Vec3& normal = planeNormals_[i];
    const double cosine = (direction - normal.dot(direction) * normal).norm();
    if (cosine < least && !shared(planeComponents_[i])) least = cosine;
  }
  return least;
}

double CollapseCost::operator()(std::uint32_t v1, std::uint32_t v2, bool planarSheet) const {
  const Vec3& target = mesh_.vertices[v2];
  const auto qem = [&] { return quadrics_[v1](target - origin_) + quadrics_[v2](target - origin_); };
  const auto qemByLength = [&] { return areas_[v1] * (target - mesh_.vertices[v1]).squaredNorm(); };
  if (!classes_ || classes_->vertices[v1] == VertexClass::Ordinary) return qem();
  if (classes_->vertices[v1] == VertexClass::Hole) return qemByLength();
  const double cosine = leastCosine(v1, v2);
  if (cosine < kAcross) return kNever;
  return a_ / cosine * (planarSheet ? qemByLength() : qem());
}

void CollapseCost::collapsed(std::uint32_t v1, std::uint32_t v2) {
  quadrics_[v2] += quadrics_[v1];
  areas_[v2] += areas_[v1];
}

}  // namespace lodestone
