#include "algorithms/simplification/half_edges.h"

#include <algorithm>
#include <array>

#include "algorithms/geometry/disjoint_sets.h"

namespace lodestone {
namespace {

using Triangle = ComponentMesh::Triangle;

/// Triangles with the winding that half-edges need.
std::vector<Triangle> woundTriangles(const ComponentMesh& mesh, const MeshEdges& edges) {
  std::vector<Triangle> triangles = mesh.triangles;
  const std::vector<bool> turn = trianglesToTurn(mesh, edges);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (turn[t]) std::swap(triangles[t][1], triangles[t][2]);
  }
  return triangles;
}

/// Whether triangle t runs from a to b.
bool runs(const Triangle& t, std::uint32_t a, std::uint32_t b) {
  return t[(cornerOf(t, a) + 1) % 3] == b;
}

/// Corners (3 · triangle + place) joined over all edges that two triangles share with one winding: the fans.
DisjointSets fansOf(const std::vector<Triangle>& triangles, const MeshEdges& edges) {
  DisjointSets fans(3 * triangles.size());
  for (std::uint32_t e = 0; e < edges.ends.size(); ++e) {
    const auto both = edges.trianglesOf(e);
    if (both.size() != 2) continue;
    const auto& [a, b] = edges.ends[e];
    const Triangle& s = triangles[both[0]];
    const Triangle& t = triangles[both[1]];
    if (runs(s, a, b) == runs(t, a, b)) continue;
    for (const std::uint32_t end : {a, b})
      (void)fans.join(3 * both[0] + cornerOf(s, end), 3 * both[1] + cornerOf(t, end));
  }
  return fans;
}

}  // namespace

HalfEdges makeHalfEdges(const ComponentMesh& mesh, const MeshEdges& edges) {
  HalfEdges result;
  const std::vector<Triangle> triangles = woundTriangles(mesh, edges);
  DisjointSets fans = fansOf(triangles, edges);
  constexpr int kNone = -1;
  std::vector<int> copyOfFan(3 * triangles.size(), kNone);
  result.mesh.reserve(mesh.vertices.size(), edges.ends.size(), triangles.size());
  const auto newCopy = [&](std::uint32_t vertex) {
    result.vertexOf.push_back(vertex);
    return result.mesh.new_vertex();
  };
  using Handle = HalfEdges::Mesh::VertexHandle;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    std::array<Handle, 3> corners;
    for (std::uint32_t i = 0; i < 3; ++i) {
      int& copy = copyOfFan[fans.find(3 * t + i)];
      if (copy == kNone) copy = newCopy(triangles[t][i]).idx();
      corners[i] = Handle(copy);
    }
    if (result.mesh.add_face(corners[0], corners[1], corners[2]).is_valid()) continue;
    for (std::uint32_t i = 0; i < 3; ++i)
      corners[i] = newCopy(triangles[t][i]);  // a face by itself always fits
    (void)result.mesh.add_face(corners[0], corners[1], corners[2]);
  }
  result.copyStart.assign(mesh.vertices.size() + 1, 0);
  for (const std::uint32_t vertex : result.vertexOf) ++result.copyStart[vertex + 1];
  for (std::size_t v = 1; v < result.copyStart.size(); ++v) result.copyStart[v] += result.copyStart[v - 1];
  std::vector<std::uint32_t> next(result.copyStart.begin(), result.copyStart.end() - 1);
  result.copies.resize(result.vertexOf.size());
  for (std::uint32_t copy = 0; copy < result.vertexOf.size(); ++copy)
    result.copies[next[result.vertexOf[copy]]++] = copy;
  return result;
}

}  // namespace lodestone
