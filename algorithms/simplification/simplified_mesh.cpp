#include "algorithms/simplification/simplified_mesh.h"

namespace lodestone {

Simplified keepTriangles(const ComponentMesh& mesh, const std::vector<Vec3>& positions,
                         const std::vector<ComponentMesh::Triangle>& triangles,
                         const std::vector<std::array<Vec2f, 3>>& textures, const std::vector<bool>& left) {
  constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  Simplified result;
  result.mesh.objects = mesh.objects;
  std::vector<std::uint32_t> vertexOf(mesh.vertices.size(), kNone);
  for (std::uint32_t c = 0; c < mesh.components.size(); ++c) {
    const Component& source = mesh.components[c];
    Component component{source.object, result.mesh.vertexCount(), 0, result.mesh.triangleCount(), 0};
    for (std::uint32_t t = source.firstTriangle; t < source.endTriangle(); ++t) {
      if (!left[t]) continue;
      ComponentMesh::Triangle triangle{};
      for (std::size_t i = 0; i < 3; ++i) {
        std::uint32_t& vertex = vertexOf[triangles[t][i]];
        if (vertex == kNone) {
          vertex = result.mesh.vertexCount();
          result.mesh.vertices.push_back(positions[triangles[t][i]]);
          result.vertex.push_back(triangles[t][i]);
        }
        triangle[i] = vertex;
      }
      result.mesh.triangles.push_back(triangle);
      result.mesh.surfaces.push_back(mesh.surfaces[t]);
      result.triangle.push_back(t);
      if (!textures.empty()) result.mesh.textureCoordinates.push_back(textures[t]);
    }
    component.vertexCount = result.mesh.vertexCount() - component.firstVertex;
    component.triangleCount = result.mesh.triangleCount() - component.firstTriangle;
    if (component.triangleCount == 0) {
      ++result.componentsRemoved;
      continue;
    }
    result.mesh.components.push_back(component);
    result.component.push_back(c);
  }
  return result;
}

}  // namespace lodestone
