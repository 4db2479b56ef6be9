// Edges of a component mesh with their triangles, and a winding on which neighbours agree.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/component_mesh.h"

namespace lodestone {

/// Undirected edges, component by component, within each by their ends.
struct MeshEdges {
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< the smaller vertex first
  std::vector<std::uint32_t> triangleStart{0};
  std::vector<std::uint32_t> triangles;                  ///< of each edge, ascending
  std::vector<std::array<std::uint32_t, 3>> ofTriangle;  ///< edge of corners i and i + 1
  std::vector<std::uint32_t> firstEdge;                  ///< by component, and the end of the last

  [[nodiscard]] std::span<const std::uint32_t> trianglesOf(std::uint32_t edge) const {
    return {triangles.data() + triangleStart[edge], triangles.data() + triangleStart[edge + 1]};
  }
  /// One triangle: it bounds a hole.
  [[nodiscard]] bool isHole(std::uint32_t edge) const {
    return triangleStart[edge + 1] - triangleStart[edge] == 1;
  }
};

/// Cost: linear, but for the sorting of each vertex's edges.
[[nodiscard]] MeshEdges makeEdges(const ComponentMesh& mesh);

/// Which of its corners a vertex is. \pre it is one
[[nodiscard]] inline std::uint32_t cornerOf(const ComponentMesh::Triangle& triangle, std::uint32_t vertex) {
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}
[[nodiscard]] inline bool hasCorner(const ComponentMesh::Triangle& triangle, std::uint32_t vertex) {
  return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

/// True when every edge of the component has an even number of triangles: then a ray that comes from far away
/// crosses it an even number of times.
[[nodiscard]] bool isClosed(const MeshEdges& edges, std::uint32_t component);

/// By triangle: whether it must be turned so that neighbours over two-sided edges agree; the greater part of
/// the area of what hangs together keeps its winding. Patches that no winding suits (Möbius) agree as far as
/// the breadth-first search got. Cost: linear.
[[nodiscard]] std::vector<bool> trianglesToTurn(const ComponentMesh& mesh, const MeshEdges& edges);

}  // namespace lodestone
