#include "algorithms/simplification/vertex_account.h"

#include <algorithm>
#include <map>

#include <Eigen/Geometry>

#include "algorithms/simplification/collapse_cost.h"
#include "algorithms/simplification/collapsing_mesh.h"
#include "algorithms/simplification/component_collapses.h"

namespace lodestone {
namespace {

/// The triangles around one vertex, and how often each neighbour is met: once at the edge of a hole.
struct Surroundings {
  std::vector<std::uint32_t> triangles;
  std::map<std::uint32_t, int> neighbours;
};

Surroundings ringOf(const ComponentMesh& mesh, std::uint32_t vertex) {
  Surroundings ring;
  const Component& component = mesh.components[componentOfVertex(mesh, vertex)];
  for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) {
    if (!hasCorner(mesh.triangles[t], vertex)) continue;
    ring.triangles.push_back(t);
    for (const std::uint32_t corner : mesh.triangles[t]) {
      if (corner != vertex) ++ring.neighbours[corner];
    }
  }
  return ring;
}

std::vector<Meeting> meetingsOf(const ComponentMesh& mesh, const Classification& classes,
                                std::uint32_t vertex) {
  std::vector<Meeting> meetings;
  for (std::uint32_t e = 0; e < classes.edges.size(); ++e) {
    const BoundaryEdge& edge = classes.edges[e];
    if (edge.from != vertex && edge.to != vertex) continue;
    const bool inside = edge.from == vertex ? edge.fromInside : edge.toInside;
    meetings.push_back({e, inside, boundaryAngle(mesh, edge)});
  }
  return meetings;
}

double areaAround(const ComponentMesh& mesh, const Classification& classes, const Surroundings& ring,
                  std::uint32_t vertex) {
  double area = 0;
  for (const std::uint32_t t : ring.triangles) area += areaNormal(mesh, t).norm() / 2;
  for (const ComponentMesh::Triangle& fill : classes.fill) {
    if (!hasCorner(fill, vertex)) continue;
    const Vec3& a = mesh.vertices[fill[0]];
    area += (mesh.vertices[fill[1]] - a).cross(mesh.vertices[fill[2]] - a).norm() / 2;
  }
  return area;
}

/// As the first step of the simplification sees them.
void addMoves(const ComponentMesh& mesh, const Classification& classes, const SimplifyOptions& options,
              std::uint32_t vertex, const Surroundings& ring, VertexAccount& account) {
  const Component& component = mesh.components[componentOfVertex(mesh, vertex)];
  const ComponentMesh own = part(mesh, component);
  const bool topology = options.method == SimplifyMethod::Topology;
  const CollapseCost cost(own, topology ? boundaryPlanes(mesh, classes, component) : BoundaryPlanes(),
                          options, bounds(mesh).center());
  const std::uint32_t v = vertex - component.firstVertex;
  if (options.method == SimplifyMethod::VertexClustering) return;
  const CollapsingMesh collapsing(own, cost);
  const bool optimal = options.method == SimplifyMethod::QemOptimal;
  const bool open = collapsing.isOpen(v);
  for (const auto& [to, count] : ring.neighbours) {
    const std::uint32_t w = to - component.firstVertex;
    const double price = costOfCollapse(cost, collapsing, optimal, v, w, open);
    account.moves.push_back({to, (mesh.vertices[to] - mesh.vertices[vertex]).norm(),
                             edgeComponentAngle(mesh, classes, vertex, to), price});
  }
  std::stable_sort(account.moves.begin(), account.moves.end(),
                   [](const MoveCost& a, const MoveCost& b) { return a.cost < b.cost; });
}

}  // namespace

double boundaryAngle(const ComponentMesh& mesh, const BoundaryEdge& edge) {
  double greatest = 0;
  for (const std::uint32_t t : edge.triangles)
    greatest = std::max(greatest, edgeComponentAngle(mesh, edge.from, edge.to, t));
  return greatest;
}

VertexAccount accountOf(const ComponentMesh& mesh, const Classification& classes,
                        const SimplifyOptions& options, std::uint32_t vertex) {
  VertexAccount account;
  account.vertexClass = classes.vertices[vertex];
  const Surroundings ring = ringOf(mesh, vertex);
  account.area = areaAround(mesh, classes, ring, vertex);
  account.onHoleEdge = std::any_of(ring.neighbours.begin(), ring.neighbours.end(),
                                   [](const auto& neighbour) { return neighbour.second == 1; });
  account.meetings = meetingsOf(mesh, classes, vertex);
  for (std::uint32_t i = classes.planeStart[vertex]; i < classes.planeStart[vertex + 1]; ++i)
    account.planes.push_back(classes.planes[i]);
  addMoves(mesh, classes, options, vertex, ring, account);
  return account;
}

}  // namespace lodestone
