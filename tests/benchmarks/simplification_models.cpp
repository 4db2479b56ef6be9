#include "simplification_models.h"

#include <array>
#include <map>
#include <random>
#include <string>

namespace lodestone::test {
namespace {

/// A closed surface of n × n quads a side, two triangles each, whose vertices are shaken by a tenth of a
/// quad.
Geometry bumpyBlock(int n, const Vec3& at, const Vec3& size, std::mt19937& random) {
  std::uniform_real_distribution<double> bump(-0.1, 0.1);
  Geometry geometry;
  geometry.lod = "3";
  std::map<std::array<int, 3>, std::uint32_t> places;
  const auto point = [&](int x, int y, int z) {
    const auto [found, added] = places.try_emplace({x, y, z}, static_cast<std::uint32_t>(places.size()));
    if (added) {
      const Vec3 shaken = Vec3(x, y, z) + Vec3(bump(random), bump(random), bump(random));
      geometry.vertices.emplace_back(at + size.cwiseProduct(shaken) / n);
    }
    return found->second;
  };
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    geometry.ringVertices.insert(geometry.ringVertices.end(), {a, b, c});
    geometry.ringStart.push_back(static_cast<std::uint32_t>(geometry.ringVertices.size()));
    geometry.finishSurface();
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto side = [&](const auto& p) {
        const std::uint32_t a = p(i, j);
        const std::uint32_t c = p(i + 1, j + 1);
        face(a, p(i + 1, j), c);
        face(a, c, p(i, j + 1));
      };
      side([&](int u, int v) { return point(v, u, 0); });
      side([&](int u, int v) { return point(u, v, n); });
      side([&](int u, int v) { return point(u, 0, v); });
      side([&](int u, int v) { return point(v, n, u); });
      side([&](int u, int v) { return point(0, v, u); });
      side([&](int u, int v) { return point(n, u, v); });
    }
  }
  return geometry;
}

CityObject objectOf(std::string id, ObjectType type, Geometry geometry) {
  CityObject object;
  object.id = std::move(id);
  object.type = type;
  object.geometries.push_back(std::move(geometry));
  return object;
}

/// Walls, a gable roof along y, and the ground.
Geometry gabledHouse(double x, double y, double width, double depth, double eaves, double ridge) {
  const auto p = [&](double u, double v, double z) { return Vec3(x + u * width, y + v * depth, z); };
  Geometry geometry;
  geometry.lod = "2";
  const auto add = [&](const std::vector<Vec3>& ring, SurfaceType type) {
    geometry.addRing(ring);
    geometry.finishSurface({type});
  };
  add({p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0)}, SurfaceType::Ground);
  add({p(0, 0, 0), p(1, 0, 0), p(1, 0, eaves), p(0.5, 0, ridge), p(0, 0, eaves)}, SurfaceType::Wall);
  add({p(1, 1, 0), p(0, 1, 0), p(0, 1, eaves), p(0.5, 1, ridge), p(1, 1, eaves)}, SurfaceType::Wall);
  add({p(1, 0, 0), p(1, 1, 0), p(1, 1, eaves), p(1, 0, eaves)}, SurfaceType::Wall);
  add({p(0, 1, 0), p(0, 0, 0), p(0, 0, eaves), p(0, 1, eaves)}, SurfaceType::Wall);
  add({p(0, 0, eaves), p(0.5, 0, ridge), p(0.5, 1, ridge), p(0, 1, eaves)}, SurfaceType::Roof);
  add({p(1, 1, eaves), p(0.5, 1, ridge), p(0.5, 0, ridge), p(1, 0, eaves)}, SurfaceType::Roof);
  return geometry;
}

}  // namespace

CityModel manyPartedBuilding() {
  std::mt19937 random(1);
  CityModel city;
  CityObject& building = city.buildings.emplace_back().object;
  building.id = "building";
  for (int i = 0; i < 400; ++i) {
    const int x = i % 20;
    const int y = i / 20;
    const Vec3 size(1.2, 1.2, 3.0 + (x * 7 + y * 3) % 5);
    building.children.push_back(objectOf("part-" + std::to_string(i), ObjectType::BuildingPart,
                                         bumpyBlock(i % 9 < 4 ? 4 : 5, Vec3(x, y, 0), size, random)));
  }
  return city;
}

CityModel rowsOfHouses(int houses) {
  std::mt19937 random(2);
  const auto some = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  CityModel city;
  double x = 0;
  double y = 0;
  int left = 0;  // of the row being built
  for (int i = 0; i < houses; ++i) {
    if (left == 0) {
      left = 1 + static_cast<int>(random() % 6);
      x += 8;
      if (x > 1000) {
        x = 0;
        y += 25;
      }
    }
    const double width = some(6, 10);
    city.buildings.emplace_back().object =
        objectOf("house-" + std::to_string(i), ObjectType::Building,
                 gabledHouse(x, y, width, some(8, 14), some(4, 7), some(8, 11)));
    x += width;
    --left;
  }
  return city;
}

ComponentMesh boxMapped(ComponentMesh mesh) {
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    int side = 0;
    (void)areaNormal(mesh, t).cwiseAbs().maxCoeff(&side);
    std::array<Vec2f, 3>& corners = mesh.textureCoordinates.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = mesh.vertices[mesh.triangles[t][i]];
      corners[i] = Vec2(p[(side + 1) % 3], p[(side + 2) % 3]).cast<float>();
    }
    mesh.surfaces[t].texture = side;
  }
  return mesh;
}

}  // namespace lodestone::test
