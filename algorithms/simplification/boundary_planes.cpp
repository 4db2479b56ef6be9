#include "algorithms/simplification/boundary_planes.h"

#include <algorithm>

namespace lodestone {
namespace {

void addPlanes(const ComponentMesh& mesh, const Classification& classes, BoundaryPlanes& planes) {
  for (std::uint32_t i = planes.start.front(); i < planes.start.back(); ++i) {
    planes.normals.push_back(areaNormal(mesh, classes.planes[i]).normalized());
    planes.components.push_back(componentOfTriangle(mesh, classes.planes[i]));
  }
  for (std::size_t v = 0; v + 1 < planes.start.size(); ++v) {
    // planes ascend, and so do their components
    for (std::uint32_t i = planes.start[v] - planes.start[0]; i < planes.start[v + 1] - planes.start[0];
         ++i) {
      const std::uint32_t component = planes.components[i];
      if (planes.met.size() == planes.metStart.back() || planes.met.back() != component)
        planes.met.push_back(component);
    }
    planes.metStart.push_back(static_cast<std::uint32_t>(planes.met.size()));
  }
}

/// The vertices from `first` up to `end`, counted from there.
BoundaryPlanes planesOf(const ComponentMesh& mesh, const Classification& classes, std::uint32_t first,
                        std::uint32_t end) {
  BoundaryPlanes planes;
  planes.classes = std::span(classes.vertices).subspan(first, end - first);
  planes.start = std::span(classes.planeStart).subspan(first, end - first + 1);
  addPlanes(mesh, classes, planes);
  const auto before = [&](std::uint32_t vertex) {
    return std::partition_point(classes.fill.begin(), classes.fill.end(),
                                [&](const ComponentMesh::Triangle& t) { return t[0] < vertex; });
  };
  for (auto t = before(first); t != before(end); ++t)
    planes.fill.push_back({(*t)[0] - first, (*t)[1] - first, (*t)[2] - first});
  return planes;
}

}  // namespace

BoundaryPlanes boundaryPlanes(const ComponentMesh& mesh, const Classification& classes) {
  return planesOf(mesh, classes, 0, mesh.vertexCount());
}

BoundaryPlanes boundaryPlanes(const ComponentMesh& mesh, const Classification& classes,
                              const Component& component) {
  return planesOf(mesh, classes, component.firstVertex, component.endVertex());
}

}  // namespace lodestone
