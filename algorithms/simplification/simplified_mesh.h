// What is left of a mesh, as a mesh of its own.
#pragma once

#include <vector>

#include "algorithms/simplification/simplification.h"

namespace lodestone {

/// The triangles of `mesh` that are left, with their present corners (vertices of `mesh`, at `positions`) and
/// texture coordinates. A component with none left is gone; one keeps its identity even where what is left of
/// it hangs together no more. Cost: linear.
[[nodiscard]] Simplified keepTriangles(const ComponentMesh& mesh, const std::vector<Vec3>& positions,
                                       const std::vector<ComponentMesh::Triangle>& triangles,
                                       const std::vector<std::array<Vec2f, 3>>& textures,
                                       const std::vector<bool>& left);

}  // namespace lodestone
