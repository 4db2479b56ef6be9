// Made-up buildings of several parts.
#pragma once

#include <array>
#include <map>
#include <numeric>
#include <random>

#include "algorithms/geometry/components.h"

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

/// An upright tube of three sides, open at both ends: six triangles, none of whose edges may collapse.
inline Faces tubeFaces(const Vec3& at, double size) {
  const std::array<Vec3, 3> foot{at, at + Vec3(size, 0, 0), at + Vec3(0, size, 0)};
  Faces faces;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = foot[i];
    const Vec3& b = foot[(i + 1) % 3];
    const Vec3 up(0, 0, size);
    faces.push_back({a, b, b + up});
    faces.push_back({a, b + up, a + up});
  }
  return faces;
}

/// A closed surface of (n × n × 6) quads with bumps, so that collapses differ in cost.
inline Faces bumpyBlock(int n, const Vec3& at, const Vec3& size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> bump(-0.2, 0.2);
  std::map<std::array<int, 3>, Vec3> points;
  const auto point = [&](int x, int y, int z) {
    auto [found, added] = points.try_emplace({x, y, z}, Vec3::Zero());
    if (added)
      found->second =
          at + (size / n).cwiseProduct(Vec3(x, y, z) + Vec3(bump(random), bump(random), bump(random)));
    return found->second;
  };
  Faces faces;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto side = [&](const auto& p) {
        const Vec3 a = p(i, j), b = p(i + 1, j), c = p(i + 1, j + 1), d = p(i, j + 1);
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
      };
      side([&](int u, int v) { return point(v, u, 0); });
      side([&](int u, int v) { return point(u, v, n); });
      side([&](int u, int v) { return point(u, 0, v); });
      side([&](int u, int v) { return point(v, n, u); });
      side([&](int u, int v) { return point(0, v, u); });
      side([&](int u, int v) { return point(n, u, v); });
    }
  }
  return faces;
}

inline Faces bumpyBlock(int n, const Vec3& at, double size, unsigned seed) {
  return bumpyBlock(n, at, Vec3(Vec3::Constant(size)), seed);
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
