#include "algorithms/mesh_edges.h"

#include <algorithm>
#include <tuple>

#include <tbb/parallel_sort.h>

namespace lodestone {
namespace {

struct Side {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t triangle = 0;
  std::uint32_t corner = 0;
  bool operator<(const Side& other) const {
    return std::tie(low, high, triangle, corner) <
           std::tie(other.low, other.high, other.triangle, other.corner);
  }
};

/// Whether the triangle runs along the edge from its smaller end to its larger one.
bool runsUp(const ComponentMesh& mesh, const MeshEdges& edges, std::uint32_t edge, std::uint32_t triangle) {
  const auto& of = edges.ofTriangle[triangle];
  const auto corner = static_cast<std::size_t>(std::find(of.begin(), of.end(), edge) - of.begin());
  return mesh.triangles[triangle][corner] == edges.ends[edge][0];
}

/// Winds what hangs together with `seed`, and keeps the winding that the greater part of the area has.
void windPatch(const ComponentMesh& mesh, const MeshEdges& edges, std::uint32_t seed, std::vector<bool>& seen,
               std::vector<bool>& turn) {
  std::vector<std::uint32_t> patch{seed};
  seen[seed] = true;
  double turned = 0;
  double kept = 0;
  for (std::size_t next = 0; next < patch.size(); ++next) {
    const std::uint32_t triangle = patch[next];
    (turn[triangle] ? turned : kept) += areaNormal(mesh, triangle).norm();
    for (const std::uint32_t edge : edges.ofTriangle[triangle]) {
      const auto both = edges.trianglesOf(edge);
      if (both.size() != 2) continue;
      const std::uint32_t neighbour = both[0] == triangle ? both[1] : both[0];
      if (seen[neighbour]) continue;
      seen[neighbour] = true;
      const bool agree = runsUp(mesh, edges, edge, triangle) != runsUp(mesh, edges, edge, neighbour);
      turn[neighbour] = turn[triangle] == agree;
      patch.push_back(neighbour);
    }
  }
  if (turned <= kept) return;
  for (const std::uint32_t triangle : patch) turn[triangle] = !turn[triangle];
}

}  // namespace

MeshEdges makeEdges(const ComponentMesh& mesh) {
  std::vector<Side> sides(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]);
      sides[3 * t + i] = {low, high, t, i};
    }
  }
  tbb::parallel_sort(sides.begin(), sides.end());
  MeshEdges edges;
  edges.ofTriangle.resize(mesh.triangles.size());
  edges.triangles.reserve(sides.size());
  std::size_t component = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    if (i == 0 || side.low != sides[i - 1].low || side.high != sides[i - 1].high) {
      if (i > 0) edges.triangleStart.push_back(static_cast<std::uint32_t>(edges.triangles.size()));
      for (; component < mesh.components.size() && side.low >= mesh.components[component].firstVertex;
           ++component)
        edges.firstEdge.push_back(static_cast<std::uint32_t>(edges.ends.size()));
      edges.ends.push_back({side.low, side.high});
    }
    edges.triangles.push_back(side.triangle);
    edges.ofTriangle[side.triangle][side.corner] = static_cast<std::uint32_t>(edges.ends.size()) - 1;
  }
  if (!sides.empty()) edges.triangleStart.push_back(static_cast<std::uint32_t>(edges.triangles.size()));
  edges.firstEdge.resize(mesh.components.size() + 1, static_cast<std::uint32_t>(edges.ends.size()));
  return edges;
}

bool isClosed(const MeshEdges& edges, std::uint32_t component) {
  for (std::uint32_t e = edges.firstEdge[component]; e < edges.firstEdge[component + 1]; ++e) {
    if (edges.trianglesOf(e).size() % 2 != 0) return false;
  }
  return true;
}

std::vector<bool> trianglesToTurn(const ComponentMesh& mesh, const MeshEdges& edges) {
  std::vector<bool> turn(mesh.triangles.size(), false);
  std::vector<bool> seen(mesh.triangles.size(), false);
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (!seen[t]) windPatch(mesh, edges, t, seen, turn);
  }
  return turn;
}

}  // namespace lodestone
