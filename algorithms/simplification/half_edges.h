// A component mesh as OpenMesh half-edges.
#pragma once

#include <cstdint>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "algorithms/geometry/mesh_edges.h"

namespace lodestone {

struct HalfEdgeTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};

/// Connectivity alone: positions and everything else stand in arrays by vertex of the ComponentMesh.
///
/// Half-edges hold manifolds with one winding. So triangles are turned to agree with their neighbours, an
/// edge that more than two triangles share (or two that no winding reconciles) is opened, and a vertex has a
/// copy for each fan of triangles that is left around it. The copies of a vertex move together or not at all:
/// nothing opens. Face f is triangle f.
struct HalfEdges {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

  Mesh mesh;
  std::vector<std::uint32_t> vertexOf;   ///< by copy: vertex of the ComponentMesh
  std::vector<std::uint32_t> copyStart;  ///< copies of vertex v: copies[copyStart[v] … copyStart[v + 1])
  std::vector<std::uint32_t> copies;

  [[nodiscard]] std::uint32_t vertexAt(Mesh::VertexHandle copy) const {
    return vertexOf[static_cast<std::size_t>(copy.idx())];
  }
};

/// Cost: O(n log n).
[[nodiscard]] HalfEdges makeHalfEdges(const ComponentMesh& mesh, const MeshEdges& edges);

}  // namespace lodestone
