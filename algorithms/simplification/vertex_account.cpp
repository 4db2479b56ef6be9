#include "algorithms/simplification/vertex_account.h"

#include <algorithm>
#include <map>

#include <Eigen/Geometry>

#include "algorithms/simplification/collapse_cost.h"
#include "algorithms/simplification/collapsing_mesh.h"
#include "algorithms/simplification/component_collapses.h"
#include "algorithms/simplification/component_contractions.h"

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

/// The component of the asked vertex, as the first step of the simplification sees it.
struct FirstStep {
  FirstStep(const ComponentMesh& mesh, const Classification& classes, const SimplifyOptions& asked,
            const Admission& admission, std::uint32_t vertex)
      : FirstStep(mesh, classes, asked, admission, vertex, componentOfVertex(mesh, vertex)) {}
  FirstStep(const ComponentMesh& mesh, const Classification& classes, const SimplifyOptions& asked,
            const Admission& admission, std::uint32_t vertex, std::uint32_t component)
      : options(asked),
        first(mesh.components[component].firstVertex),
        v(vertex - first),
        origin(bounds(mesh).center()),
        own(part(mesh, mesh.components[component])),
        scope(needsPerception(options.method) ? scopeOf(mesh, component, admission) : Scope()),
        cost(own,
             needsTopology(options.method) ? boundaryPlanes(mesh, classes, mesh.components[component])
                                           : BoundaryPlanes(),
             options, origin),
        collapsing(own, cost) {}

  [[nodiscard]] bool leadsTooFar(std::uint32_t w, const Vec3& at) const {
    return needsPerception(options.method) && options.error > 0 &&
           cost.meanDistance(v, w, at) > options.error;
  }

  const SimplifyOptions& options;
  std::uint32_t first;
  std::uint32_t v;  ///< in its component
  Vec3 origin;
  ComponentMesh own;
  Scope scope;
  CollapseCost cost;
  CollapsingMesh collapsing;
};

void addCollapses(const ComponentMesh& mesh, const Classification& classes, const FirstStep& step,
                  const Surroundings& ring, std::uint32_t vertex, VertexAccount& account) {
  const bool optimal = step.options.method == SimplifyMethod::QemOptimal;
  const bool open = step.collapsing.isOpen(step.v);
  for (const auto& [to, count] : ring.neighbours) {
    const std::uint32_t w = to - step.first;
    const bool never = account.held || step.leadsTooFar(w, step.cost.position(w));
    account.moves.push_back(
        {to,
         (mesh.vertices[to] - mesh.vertices[vertex]).norm(),
         edgeComponentAngle(mesh, classes, vertex, to),
         never ? CollapseCost::kNever : costOfCollapse(step.cost, step.collapsing, optimal, step.v, w, open),
         {}});
  }
}

void addContractions(const FirstStep& step, VertexAccount& account) {
  const PerceptualCost look(step.collapsing, step.own.vertexCount(), step.origin);
  std::map<std::uint32_t, std::uint32_t> edges;  // one to each neighbour
  step.collapsing.forEachEdge(step.v, [&](std::uint32_t edge) {
    const auto& [v1, v2] = step.collapsing.ends(edge);
    edges.emplace(v1 == step.v ? v2 : v1, edge);
  });
  for (const auto& [w, edge] : edges) {
    const auto& [v1, v2] = step.collapsing.ends(edge);
    MoveCost move{w + step.first,
                  (step.own.vertices[w] - step.own.vertices[step.v]).norm(),
                  0,
                  CollapseCost::kNever,
                  {}};
    const CollapseCost::Placements places = placesToContract(step.cost, step.scope, v1, v2);
    if (places.count > 0) {
      const auto& [at, qem] = places.places.front();
      move.perceived = look(edge, at, qem);
      if (!step.leadsTooFar(w, at)) move.cost = move.perceived->cost();
    }
    account.moves.push_back(move);
  }
}

void addMoves(const ComponentMesh& mesh, const Classification& classes, const SimplifyOptions& options,
              const Admission& admission, const Surroundings& ring, std::uint32_t vertex,
              VertexAccount& account) {
  if (options.method == SimplifyMethod::VertexClustering) return;
  const FirstStep step(mesh, classes, options, admission, vertex);
  account.held = step.scope.holds(step.v);
  if (options.method == SimplifyMethod::Perception)
    addContractions(step, account);
  else
    addCollapses(mesh, classes, step, ring, vertex, account);
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
                        const SimplifyOptions& options, std::uint32_t vertex, const Admission& admission) {
  VertexAccount account;
  account.vertexClass = classes.vertices[vertex];
  const Surroundings ring = ringOf(mesh, vertex);
  account.area = areaAround(mesh, classes, ring, vertex);
  account.onHoleEdge = std::any_of(ring.neighbours.begin(), ring.neighbours.end(),
                                   [](const auto& neighbour) { return neighbour.second == 1; });
  account.meetings = meetingsOf(mesh, classes, vertex);
  for (std::uint32_t i = classes.planeStart[vertex]; i < classes.planeStart[vertex + 1]; ++i)
    account.planes.push_back(classes.planes[i]);
  addMoves(mesh, classes, options, admission, ring, vertex, account);
  return account;
}

}  // namespace lodestone
