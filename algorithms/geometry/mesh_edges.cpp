#include "algorithms/geometry/mesh_edges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace lodestone {
namespace {

/// A side of a triangle, seen from its smaller end.
struct Side {
  std::uint32_t high = 0;
  std::uint32_t triangle = 0;
  std::uint32_t corner = 0;
  bool operator<(const Side& other) const {
    return std::tie(high, triangle, corner) < std::tie(other.high, other.triangle, other.corner);
  }
};

/// The sides of all triangles, those of one smaller end together.
struct SortedSides {
  std::vector<std::uint32_t> start;  ///< by smaller end
  std::vector<Side> sides;
};

SortedSides sortedSides(const ComponentMesh& mesh) {
  SortedSides result;
  result.start.assign(mesh.vertices.size() + 1, 0);
  const auto forEachSide = [&](const auto& visit) {
    for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t a = mesh.triangles[t][i];
        const std::uint32_t b = mesh.triangles[t][(i + 1) % 3];
        visit(std::min(a, b), Side{std::max(a, b), t, i});
      }
    }
  };
  forEachSide([&](std::uint32_t low, const Side&) { ++result.start[low + 1]; });
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.sides.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(result.start.begin(), result.start.end() - 1);
  forEachSide([&](std::uint32_t low, const Side& side) { result.sides[next[low]++] = side; });
  for (std::size_t v = 0; v + 1 < result.start.size(); ++v)
    std::sort(result.sides.begin() + result.start[v], result.sides.begin() + result.start[v + 1]);
  return result;
}

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
  const SortedSides sorted = sortedSides(mesh);
  MeshEdges edges;
  edges.ofTriangle.resize(mesh.triangles.size());
  edges.triangles.reserve(sorted.sides.size());
  for (const Component& component : mesh.components) {
    edges.firstEdge.push_back(static_cast<std::uint32_t>(edges.ends.size()));
    for (std::uint32_t low = component.firstVertex; low < component.endVertex(); ++low) {
      for (std::uint32_t i = sorted.start[low]; i < sorted.start[low + 1]; ++i) {
        const Side& side = sorted.sides[i];
        if (i == sorted.start[low] || side.high != sorted.sides[i - 1].high) {
          if (!edges.ends.empty())
            edges.triangleStart.push_back(static_cast<std::uint32_t>(edges.triangles.size()));
          edges.ends.push_back({low, side.high});
        }
        edges.triangles.push_back(side.triangle);
        edges.ofTriangle[side.triangle][side.corner] = static_cast<std::uint32_t>(edges.ends.size()) - 1;
      }
    }
  }
  if (!edges.ends.empty()) edges.triangleStart.push_back(static_cast<std::uint32_t>(edges.triangles.size()));
  edges.firstEdge.push_back(static_cast<std::uint32_t>(edges.ends.size()));
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
