// A building, or a group of buildings that touch, as the building-scale methods see it: triangles in
// components, and what their vertices are (Wang et al. 2021, sections 3.1 and 3.2;
// resources/docs/methods.md, 2.1 and 2.2).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/city_model.h"

namespace lodestone {

/// A connected set of triangles of one source object.
struct Component {
  std::uint32_t object = 0;  ///< index into ComponentMesh::objects
  std::uint32_t firstVertex = 0;
  std::uint32_t vertexCount = 0;
  std::uint32_t firstTriangle = 0;
  std::uint32_t triangleCount = 0;
  [[nodiscard]] std::uint32_t endVertex() const { return firstVertex + vertexCount; }
  [[nodiscard]] std::uint32_t endTriangle() const { return firstTriangle + triangleCount; }
};

/// Indexed triangles, counter-clockwise from outside where the source is. Vertices are shared within a source
/// object (same position) and never between two; both vertices and triangles stand component by component.
struct ComponentMesh {
  using Triangle = std::array<std::uint32_t, 3>;

  /// Where triangles come from: an OBJ group, a glTF or COLLADA node, a Building, a BuildingPart, ….
  struct SourceObject {
    std::string id;
    std::uint32_t building = 0;  ///< index into the buildings that the mesh was made of
    std::string lod;
  };

  std::vector<SourceObject> objects;
  std::vector<Component> components;
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<SurfaceInfo> surfaces;  ///< of each triangle: its semantics, material, texture
  std::vector<std::array<Vec2f, 3>>
      textureCoordinates;  ///< of each triangle's corners; empty where none has any

  [[nodiscard]] std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(vertices.size()); }
  [[nodiscard]] std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(triangles.size()); }
};

/// One component by itself: its vertices and triangles are counted from its first.
[[nodiscard]] ComponentMesh part(const ComponentMesh& mesh, const Component& component);

/// Component of every vertex, by binary search over few components. Cost: O(log components).
[[nodiscard]] std::uint32_t componentOfVertex(const ComponentMesh& mesh, std::uint32_t vertex);
[[nodiscard]] std::uint32_t componentOfTriangle(const ComponentMesh& mesh, std::uint32_t triangle);
/// Twice the area vector of a triangle: its normal, as long as twice its area.
[[nodiscard]] Vec3 areaNormal(const ComponentMesh& mesh, std::uint32_t triangle);
[[nodiscard]] Box3 bounds(const ComponentMesh& mesh);
[[nodiscard]] Box3 bounds(const ComponentMesh& mesh, const Component& component);

enum class VertexClass : std::uint8_t { Ordinary, Boundary, Hole };
[[nodiscard]] const char* toString(VertexClass vertexClass);

/// Which rule said what end of a boundary edge lies inside the other component.
enum class InsideRule : std::uint8_t {
  Solid,   ///< the other component is closed: a ray cast from the end counts crossings, whatever the winding
  Normal,  ///< it is open: the angle between the edge and the normal of the triangle that it meets
  Touch,   ///< the end lies on the other component, or its edge lies in the plane of one of its triangles
  Lengthened  ///< the edge meets it only in the part by which the end was lengthened
};
[[nodiscard]] const char* toString(InsideRule rule);

/// An edge that meets another component.
struct BoundaryEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  bool fromInside = false;  ///< the end is a boundary vertex by this edge
  bool toInside = false;
  bool passesThrough = false;  ///< both ends are outside
  InsideRule rule = InsideRule::Normal;
  std::uint32_t other = 0;               ///< the component that it meets
  std::vector<std::uint32_t> triangles;  ///< of it, ascending
};

/// What the vertices of a ComponentMesh are.
struct Classification {
  double gap = 0.01;
  std::vector<VertexClass> vertices;
  /// Reference planes of vertex v: triangles planes[planeStart[v] … planeStart[v + 1]), ascending; none for a
  /// vertex that is not boundary.
  std::vector<std::uint32_t> planeStart{0};
  std::vector<std::uint32_t> planes;
  std::vector<BoundaryEdge> edges;  ///< by component, ends, other component
  /// Triangles over holes between boundary vertices, component by component: they serve the cost alone.
  std::vector<ComponentMesh::Triangle> fill;
  /// Pairs of components that touch, the smaller index first, ascending.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> contacts;

  [[nodiscard]] std::uint32_t planeCount(std::uint32_t vertex) const {
    return planeStart[vertex + 1] - planeStart[vertex];
  }
};

/// E–C angle of the collapse `from` → `to`, degrees: between the edge and the plane of the triangle; 0 in the
/// plane, 90 across it (Wang et al. 2021, section 3.3.1).
[[nodiscard]] double edgeComponentAngle(const ComponentMesh& mesh, std::uint32_t from, std::uint32_t to,
                                        std::uint32_t triangle);
/// The greatest E–C angle over the reference planes of `from`; 0 where it has none. Planes of a component
/// that both ends have planes of count 0: both lie inside it.
[[nodiscard]] double edgeComponentAngle(const ComponentMesh& mesh, const Classification& classes,
                                        std::uint32_t from, std::uint32_t to);

}  // namespace lodestone
