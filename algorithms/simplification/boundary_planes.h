// The planes that boundary vertices hold on to, as the cost of a collapse asks for them (Wang et al. 2021,
// section 3.3.1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/component_mesh.h"

namespace lodestone {

/// Of a mesh, or of one component of it whose vertices are counted from its first. Views into the
/// classification that it was made of.
struct BoundaryPlanes {
  std::span<const VertexClass> classes;  ///< by vertex; empty where classes do not count
  std::span<const std::uint32_t>
      start;                  ///< planes of vertex v: start[v] − start[0] … start[v + 1] − start[0]
  std::vector<Vec3> normals;  ///< unit, of each plane
  std::vector<std::uint32_t> components;  ///< that each plane is of
  std::vector<std::uint32_t> metStart{0};
  std::vector<std::uint32_t>
      met;  ///< components of the planes of v: met[metStart[v] … metStart[v + 1]), ascending
  std::vector<ComponentMesh::Triangle> fill;  ///< of holes
};

/// Cost: linear.
[[nodiscard]] BoundaryPlanes boundaryPlanes(const ComponentMesh& mesh, const Classification& classes);
[[nodiscard]] BoundaryPlanes boundaryPlanes(const ComponentMesh& mesh, const Classification& classes,
                                            const Component& component);

}  // namespace lodestone
