// Made-up buildings of several parts.
#pragma once

#include <numeric>

#include "algorithms/components.h"

namespace lodestone {

/// Quads and triangles of one source object.
using Faces = std::vector<std::vector<Vec3>>;

inline Faces boxFaces(const Vec3& min, const Vec3& max) {
  const auto p = [&](int x, int y, int z) {
    return Vec3(x ? max.x() : min.x(), y ? max.y() : min.y(), z ? max.z() : min.z());
  };
  return {{p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0)}, {p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)},
          {p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1)}, {p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1)},
          {p(1, 1, 0), p(0, 1, 0), p(0, 1, 1), p(1, 1, 1)}, {p(0, 1, 0), p(0, 0, 0), p(0, 0, 1), p(0, 1, 1)}};
}

/// One building, each of whose parts has the faces of one object.
inline CityModel cityOfParts(const std::vector<Faces>& parts) {
  CityModel city;
  city.buildings.emplace_back();
  CityObject& object = city.buildings.front().object;
  object.id = "building";
  object.type = ObjectType::Building;
  for (const Faces& faces : parts) {
    CityObject part;
    part.id = "part-" + std::to_string(object.children.size());
    part.type = ObjectType::BuildingPart;
    Geometry& geometry = part.geometries.emplace_back();
    geometry.lod = "3";
    for (const auto& face : faces) {
      geometry.addRing(face);
      geometry.finishSurface();
    }
    object.children.push_back(std::move(part));
  }
  return city;
}

inline ComponentMesh meshOfParts(const std::vector<Faces>& parts) {
  const std::uint32_t first = 0;
  return makeComponentMesh(cityOfParts(parts), {&first, 1});
}

/// The vertex at a position in a component; 0xFFFFFFFF where there is none.
inline std::uint32_t vertexAt(const ComponentMesh& mesh, std::uint32_t component, const Vec3& position) {
  const Component& c = mesh.components[component];
  for (std::uint32_t v = c.firstVertex; v < c.endVertex(); ++v) {
    if (mesh.vertices[v] == position) return v;
  }
  return 0xFFFFFFFFU;
}

}  // namespace lodestone
