// Triangles over the holes of a mesh (Wang et al. 2021, section 3.2.3).
#pragma once

#include <vector>

#include "algorithms/geometry/mesh_edges.h"

namespace lodestone {

/// A closed chain of edges that have one triangle each, in the direction that a triangle over the hole has.
using HoleLoop = std::vector<std::uint32_t>;

/// The loops of a component's hole edges. Chains that branch (bow-ties) are cut at the vertex where they meet
/// themselves. `turn` says which triangles are wound against their neighbours (trianglesToTurn()). Cost:
/// linear but for sorting.
[[nodiscard]] std::vector<HoleLoop> holeLoops(const ComponentMesh& mesh, const MeshEdges& edges,
                                              std::uint32_t component, const std::vector<bool>& turn);

/// Triangles over a loop: triangulated in the plane it faces most, ear by ear where it crosses itself there.
[[nodiscard]] std::vector<ComponentMesh::Triangle> fillHole(const ComponentMesh& mesh, const HoleLoop& loop);

}  // namespace lodestone
