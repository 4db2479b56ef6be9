#include "model/component_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace lodestone {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

}  // namespace

const char* toString(VertexClass vertexClass) {
  switch (vertexClass) {
    case VertexClass::Ordinary:
      return "ordinary";
    case VertexClass::Boundary:
      return "boundary";
    case VertexClass::Hole:
      return "hole";
  }
  return "";
}

const char* toString(InsideRule rule) {
  switch (rule) {
    case InsideRule::Solid:
      return "solid";
    case InsideRule::Normal:
      return "normal";
    case InsideRule::Touch:
      return "touch";
    case InsideRule::Lengthened:
      return "lengthened";
  }
  return "";
}

std::uint32_t componentOfVertex(const ComponentMesh& mesh, std::uint32_t vertex) {
  const auto after = std::upper_bound(mesh.components.begin(), mesh.components.end(), vertex,
                                      [](std::uint32_t v, const Component& c) { return v < c.firstVertex; });
  return static_cast<std::uint32_t>(after - mesh.components.begin()) - 1;
}

std::uint32_t componentOfTriangle(const ComponentMesh& mesh, std::uint32_t triangle) {
  const auto after =
      std::upper_bound(mesh.components.begin(), mesh.components.end(), triangle,
                       [](std::uint32_t t, const Component& c) { return t < c.firstTriangle; });
  return static_cast<std::uint32_t>(after - mesh.components.begin()) - 1;
}

ComponentMesh part(const ComponentMesh& mesh, const Component& component) {
  const auto slice = [](const auto& all, std::uint32_t first, std::uint32_t count) {
    const auto begin = all.begin() + first;
    return std::remove_cvref_t<decltype(all)>(begin, begin + count);
  };
  ComponentMesh result;
  result.objects = {mesh.objects[component.object]};
  result.components = {{0, 0, component.vertexCount, 0, component.triangleCount}};
  result.vertices = slice(mesh.vertices, component.firstVertex, component.vertexCount);
  result.triangles = slice(mesh.triangles, component.firstTriangle, component.triangleCount);
  for (ComponentMesh::Triangle& triangle : result.triangles) {
    for (std::uint32_t& corner : triangle) corner -= component.firstVertex;
  }
  result.surfaces = slice(mesh.surfaces, component.firstTriangle, component.triangleCount);
  if (!mesh.textureCoordinates.empty())
    result.textureCoordinates =
        slice(mesh.textureCoordinates, component.firstTriangle, component.triangleCount);
  return result;
}

Vec3 areaNormal(const ComponentMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
}

Box3 bounds(const ComponentMesh& mesh) {
  Box3 box;
  for (const Vec3& vertex : mesh.vertices) box.add(vertex);
  return box;
}

Box3 bounds(const ComponentMesh& mesh, const Component& component) {
  Box3 box;
  for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v) box.add(mesh.vertices[v]);
  return box;
}

double edgeComponentAngle(const ComponentMesh& mesh, std::uint32_t from, std::uint32_t to,
                          std::uint32_t triangle) {
  const Vec3 edge = mesh.vertices[to] - mesh.vertices[from];
  const Vec3 normal = areaNormal(mesh, triangle);
  const double lengths = edge.norm() * normal.norm();
  if (lengths == 0) return 0;
  return std::asin(std::min(1.0, std::abs(edge.dot(normal)) / lengths)) * kDegrees;
}

double edgeComponentAngle(const ComponentMesh& mesh, const Classification& classes, std::uint32_t from,
                          std::uint32_t to) {
  const auto planesOf = [&](std::uint32_t v) {
    return std::pair(classes.planes.begin() + classes.planeStart[v],
                     classes.planes.begin() + classes.planeStart[v + 1]);
  };
  const auto [begin, end] = planesOf(from);
  const auto [toBegin, toEnd] = planesOf(to);
  double greatest = 0;
  for (auto plane = begin; plane != end; ++plane) {
    const Component& other = mesh.components[componentOfTriangle(mesh, *plane)];
    const auto shared = std::lower_bound(toBegin, toEnd, other.firstTriangle);
    if (shared != toEnd && *shared < other.endTriangle()) continue;
    greatest = std::max(greatest, edgeComponentAngle(mesh, from, to, *plane));
  }
  return greatest;
}

}  // namespace lodestone
