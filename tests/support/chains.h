// Small chains made by hand, for the tests of writers.
#pragma once

#include <memory>

#include <fmt/format.h>

#include "algorithms/geometry/meshing.h"
#include "model/lod_chain.h"

namespace lodestone::test {

inline MultiPolygon square(double x, double y, double side) {
  return {{{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, {}}};
}

inline LevelObject blockObject(const std::string& id, const MultiPolygon& footprint, double base,
                               double height) {
  LevelObject object;
  object.id = id;
  object.base = base;
  object.height = height;
  object.footprint = footprint;
  object.geometries.push_back(makeBlock(footprint, base, height));
  object.triangles.push_back(triangulate(object.geometries.back()));
  return object;
}

/// `count` houses in a row with attributes, one with a hole; level 1 has them as one cluster with the first
/// as landmark.
inline LodChain rowOfHouses(std::uint32_t count) {
  auto city = std::make_shared<CityModel>();
  city->origin = Vec3(389000.5, 5820000.25, 30);
  city->crs = {"EPSG:25833", "ETRS89 / UTM zone 33N", 25833, 0, CrsKind::Projected};
  city->sources.push_back({"row.gml", "citygml", "2.0", ""});
  for (std::uint32_t i = 0; i < count; ++i) {
    Building building;
    building.object.id = fmt::format("house {}%", i);
    building.object.type = ObjectType::Building;
    building.object.attributes.set("storeys", std::int64_t{i % 5});
    building.object.attributes.set("first name", std::string(i % 2 == 0 ? "Jürgen" : "An\xFF"));
    if (i % 3 == 0) building.object.attributes.set("roof height", 1.5 * i);
    building.footprint = square(20.0 * i, 5, 10);
    if (i == 1) building.footprint[0].holes.push_back({{22, 7}, {22, 9}, {24, 9}, {24, 7}});
    building.base = 3;
    building.height = 6 + i % 4;
    city->buildings.push_back(std::move(building));
  }
  LodChain chain{
      city, nullptr, {}, R"({"type":"recipe","version":1,"source":["row.gml"],"levels":[],"exports":[]})"};
  LodLevel original;
  original.name = "original";
  original.method = "original";
  original.isCity = true;
  original.objectCount = count;
  original.object = [city](std::size_t i) {
    const Building& b = city->buildings[i];
    LevelObject object = blockObject(b.object.id, b.footprint, b.base, b.height);
    object.node = static_cast<NodeId>(i);
    object.buildings = {static_cast<std::uint32_t>(i)};
    return object;
  };
  LodLevel coarse;
  coarse.name = "legible-5m";
  coarse.method = "legible";
  coarse.error = 5;
  coarse.objectCount = 2;
  coarse.object = [city, count](std::size_t i) {
    if (i == 1) {
      const Building& b = city->buildings[0];
      LevelObject landmark = blockObject(b.object.id, b.footprint, b.base, b.height);
      landmark.role = DrawRole::Landmark;
      landmark.node = 0;
      landmark.of = 99;
      landmark.buildings = {0};
      return landmark;
    }
    LevelObject cluster =
        blockObject("cluster-99", {{{{0, 5}, {20.0 * count, 5}, {20.0 * count, 15}, {0, 15}}, {}}}, 3, 7);
    cluster.role = DrawRole::Cluster;
    cluster.node = 99;
    cluster.negative = 42;
    for (std::uint32_t b = 0; b < count; ++b) cluster.buildings.push_back(b);
    return cluster;
  };
  chain.levels = {original, coarse};
  return chain;
}

}  // namespace lodestone::test
