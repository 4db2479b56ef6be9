#include "algorithms/simplification/collapse_cost.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "algorithms/geometry/mesh_edges.h"
#include "algorithms/simplification/surface_charts.h"

namespace lodestone {
namespace {

/// An edge that stands across its reference plane is never collapsed (methods.md, 2.3).
constexpr double kAcross = 1e-6;
/// A move is along the planes of a vertex when the root mean square of its sines to them is below this.
constexpr double kAlong = 0.3;

/// Whether an edge's two triangles look different on its two sides, or at one of its ends.
bool isChartBorder(const ComponentMesh& mesh, const MeshEdges& edges, std::uint32_t e) {
  const auto both = edges.trianglesOf(e);
  if (both.size() != 2) return false;
  const auto place = [&](std::uint32_t t, std::uint32_t v) {
    return mesh.textureCoordinates.empty() ? Vec2f(Vec2f::Zero())
                                           : mesh.textureCoordinates[t][cornerOf(mesh.triangles[t], v)];
  };
  const auto differsAt = [&](std::uint32_t v) {
    return !sameChart(mesh.surfaces[both[0]], mesh.surfaces[both[1]], place(both[0], v), place(both[1], v));
  };
  return differsAt(edges.ends[e][0]) || differsAt(edges.ends[e][1]);
}

}  // namespace

CollapseCost::CollapseCost(const ComponentMesh& mesh, const Classification* classes,
                           const SimplifyOptions& options)
    : CollapseCost(mesh, classes ? boundaryPlanes(mesh, *classes) : BoundaryPlanes(), options,
                   bounds(mesh).center()) {}

CollapseCost::CollapseCost(const ComponentMesh& mesh, BoundaryPlanes planes, const SimplifyOptions& options,
                           const Vec3& origin)
    : planes_(std::move(planes)),
      a_(options.a),
      rimPlanes_(options.rimPlanes || options.method == SimplifyMethod::Perception),
      origin_(origin),
      vertices_(mesh.vertices.size()) {
  for (std::size_t v = 0; v < vertices_.size(); ++v) vertices_[v].position = mesh.vertices[v];
  for (const ComponentMesh::Triangle& triangle : mesh.triangles) add(mesh, triangle);
  for (const ComponentMesh::Triangle& triangle : planes_.fill) add(mesh, triangle);
  if (rimPlanes_) addRims(mesh, options.method == SimplifyMethod::Perception);
}

/// Through each open edge, across its triangle, as heavy as the square over the edge. The square does not
/// count as area that goes with a vertex. `borders`: through those between charts as well, across both.
void CollapseCost::addRims(const ComponentMesh& mesh, bool borders) {
  const MeshEdges edges = makeEdges(mesh);
  for (std::uint32_t e = 0; e < edges.ends.size(); ++e) {
    if (!edges.isHole(e) && !(borders && isChartBorder(mesh, edges, e))) continue;
    const auto& [from, to] = edges.ends[e];
    const Vec3 along = mesh.vertices[to] - mesh.vertices[from];
    for (const std::uint32_t t : edges.trianglesOf(e)) {
      const Vec3 across = areaNormal(mesh, t).cross(along).normalized();
      const Quadric quadric(2 * along.squaredNorm() * across, mesh.vertices[from] - origin_);
      for (const std::uint32_t end : {from, to}) vertices_[end].quadric += quadric;
    }
  }
}

void CollapseCost::add(const ComponentMesh& mesh, const ComponentMesh::Triangle& triangle) {
  const Vec3& a = mesh.vertices[triangle[0]];
  const Vec3 normal = (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
  const Quadric quadric(normal, a - origin_);
  for (const std::uint32_t vertex : triangle) {
    vertices_[vertex].quadric += quadric;
    vertices_[vertex].area += normal.norm() / 2;
  }
}

double CollapseCost::leastCosine(std::uint32_t v1, std::uint32_t v2) const {
  const Vec3 direction = (vertices_[v2].position - vertices_[v1].position).normalized();
  const auto firstMet = planes_.met.begin() + planes_.metStart[v2];
  const auto endMet = planes_.met.begin() + planes_.metStart[v2 + 1];
  const auto both = [&](std::uint32_t component) { return std::find(firstMet, endMet, component) != endMet; };
  double greatest = 0;  // sine of the angle to a plane
  const Vec3* steepest = nullptr;
  for (std::uint32_t i = planes_.start[v1] - planes_.start[0]; i < planes_.start[v1 + 1] - planes_.start[0];
       ++i) {
    const double sine = std::abs(planes_.normals[i].dot(direction));
    if (sine <= greatest || both(planes_.components[i])) continue;
    greatest = sine;
    steepest = &planes_.normals[i];
  }
  return steepest ? (direction - steepest->dot(direction) * *steepest).norm() : 1;
}

double CollapseCost::qemStar(std::uint32_t v1, std::uint32_t v2) const {
  return vertices_[v1].area * (vertices_[v2].position - vertices_[v1].position).squaredNorm();
}

/// Of a boundary vertex, by what it costs others.
double CollapseCost::held(std::uint32_t v1, std::uint32_t v2, double base, double most) const {
  if (a_ * base > most) return kNever;
  const double cosine = leastCosine(v1, v2);
  return cosine < kAcross ? kNever : a_ * base / cosine;
}

double CollapseCost::byLength(std::uint32_t v1, std::uint32_t v2, double most) const {
  return isBoundary(v1) ? held(v1, v2, qemStar(v1, v2), most) : qemStar(v1, v2);
}

double CollapseCost::operator()(std::uint32_t v1, std::uint32_t v2, bool open, double most) const {
  const auto byQem = [&] { return qem(v1, v2, vertices_[v2].position); };
  if (planes_.classes.empty() || planes_.classes[v1] == VertexClass::Ordinary) return byQem();
  const bool isHole = planes_.classes[v1] == VertexClass::Hole;
  if (rimPlanes_) return isHole ? byQem() : held(v1, v2, byQem(), most);
  if (isHole) return qemStar(v1, v2);
  const double byPlanes = byQem();
  const double byLength = qemStar(v1, v2);
  return held(v1, v2, open && byPlanes <= kAlong * kAlong * byLength ? byLength : byPlanes, most);
}

/// Relative to the origin: v2, v1, the middle and the quadrics' minimum.
CollapseCost::Placements CollapseCost::placesFor(std::uint32_t v1, std::uint32_t v2) const {
  Quadric sum = vertices_[v1].quadric;
  sum += vertices_[v2].quadric;
  const Vec3 p1 = vertices_[v1].position - origin_;
  const Vec3 p2 = vertices_[v2].position - origin_;
  const Vec3 middle = (p1 + p2) / 2;
  Placements result{{{{p2, sum(p2)}, {p1, sum(p1)}, {middle, sum(middle)}, {}}}, 3};
  const std::optional<Vec3> least = sum.minimum();
  if (least && (*least - middle).norm() <= 2 * (p2 - p1).norm())
    result.places[result.count++] = {*least, sum(*least)};
  return result;
}

CollapseCost::Placement CollapseCost::contraction(std::uint32_t v1, std::uint32_t v2) const {
  const Placements all = placesFor(v1, v2);
  Placement best = *std::min_element(all.places.begin(), all.places.begin() + all.count,
                                     [](const Placement& a, const Placement& b) { return a.cost < b.cost; });
  best.at += origin_;
  return best;
}

CollapseCost::Placements CollapseCost::contractions(std::uint32_t v1, std::uint32_t v2) const {
  Placements all = placesFor(v1, v2);
  for (std::size_t i = 0; i < all.count; ++i) all.places[i].at += origin_;
  all.places[0].at = position(v2);
  all.places[1].at = position(v1);
  std::stable_sort(all.places.begin(), all.places.begin() + all.count,
                   [](const Placement& a, const Placement& b) { return a.cost < b.cost; });
  return all;
}

Vec3 CollapseCost::areaNormalOf(const ComponentMesh::Triangle& triangle) const {
  const Vec3& a = position(triangle[0]);
  return (position(triangle[1]) - a).cross(position(triangle[2]) - a);
}

double CollapseCost::qem(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
  return vertices_[v1].quadric(at - origin_) + vertices_[v2].quadric(at - origin_);
}

double CollapseCost::meanDistance(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
  const double weight = vertices_[v1].quadric.weight() + vertices_[v2].quadric.weight();
  return weight > 0 ? std::sqrt(qem(v1, v2, at) / weight) : 0;
}

void CollapseCost::collapsed(std::uint32_t v1, std::uint32_t v2, const Vec3& at) {
  vertices_[v2].position = at;
  vertices_[v2].quadric += vertices_[v1].quadric;
  vertices_[v2].area += vertices_[v1].area;
}

}  // namespace lodestone
