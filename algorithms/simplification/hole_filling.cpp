#include "algorithms/simplification/hole_filling.h"

#include <algorithm>
#include <unordered_map>

#include "algorithms/geometry/meshing.h"

namespace lodestone {
namespace {

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

/// Edges of the component that have one triangle, turned against it.
std::vector<DirectedEdge> holeEdges(const ComponentMesh& mesh, const MeshEdges& edges,
                                    std::uint32_t component, const std::vector<bool>& turn) {
  std::vector<DirectedEdge> holes;
  for (std::uint32_t e = edges.firstEdge[component]; e < edges.firstEdge[component + 1]; ++e) {
    if (!edges.isHole(e)) continue;
    const std::uint32_t triangle = edges.trianglesOf(e).front();
    const auto& of = edges.ofTriangle[triangle];
    const auto corner = static_cast<std::size_t>(std::find(of.begin(), of.end(), e) - of.begin());
    DirectedEdge hole{mesh.triangles[triangle][(corner + 1) % 3], mesh.triangles[triangle][corner]};
    if (turn[triangle]) std::swap(hole.first, hole.second);
    holes.push_back(hole);
  }
  std::sort(holes.begin(), holes.end());
  return holes;
}

}  // namespace

std::vector<HoleLoop> holeLoops(const ComponentMesh& mesh, const MeshEdges& meshEdges,
                                std::uint32_t component, const std::vector<bool>& turn) {
  const std::vector<DirectedEdge> edges = holeEdges(mesh, meshEdges, component, turn);
  std::vector<bool> used(edges.size(), false);
  const auto leaving = [&](std::uint32_t vertex) {
    auto edge = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{vertex, 0});
    while (edge != edges.end() && edge->first == vertex &&
           used[static_cast<std::size_t>(edge - edges.begin())])
      ++edge;
    return edge != edges.end() && edge->first == vertex ? edge - edges.begin() : std::ptrdiff_t{-1};
  };
  std::vector<HoleLoop> loops;
  for (std::size_t seed = 0; seed < edges.size(); ++seed) {
    if (used[seed]) continue;
    HoleLoop chain;
    std::unordered_map<std::uint32_t, std::size_t> place;  // of the chain's vertices
    for (auto edge = static_cast<std::ptrdiff_t>(seed); edge >= 0;) {
      used[static_cast<std::size_t>(edge)] = true;
      const auto [from, to] = edges[static_cast<std::size_t>(edge)];
      place[from] = chain.size();
      chain.push_back(from);
      const auto met = place.find(to);
      if (met != place.end()) {  // the chain meets itself: what lies between is a loop
        const auto begin = chain.begin() + static_cast<std::ptrdiff_t>(met->second);
        HoleLoop loop(begin, chain.end());
        for (const std::uint32_t vertex : loop) place.erase(vertex);
        chain.erase(begin, chain.end());
        if (loop.size() > 2) loops.push_back(std::move(loop));
      }
      edge = leaving(to);
    }
  }
  return loops;
}

std::vector<ComponentMesh::Triangle> fillHole(const ComponentMesh& mesh, const HoleLoop& loop) {
  std::vector<Vec3> ring;
  for (const std::uint32_t vertex : loop) ring.push_back(mesh.vertices[vertex]);
  Geometry geometry;
  geometry.addRing(ring);
  geometry.finishSurface();
  std::vector<ComponentMesh::Triangle> triangles;
  for (const LevelObject::Triangle& t : triangulate(geometry))
    triangles.push_back({loop[t.vertices[0]], loop[t.vertices[1]], loop[t.vertices[2]]});
  return triangles;
}

}  // namespace lodestone
