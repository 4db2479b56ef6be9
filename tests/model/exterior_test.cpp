#include "model/exterior.h"

#include <gtest/gtest.h>

namespace lodestone {
namespace {

/// A solid, as far as anybody here looks.
Geometry block(const std::string& lod, double x) {
  Geometry geometry;
  geometry.lod = lod;
  geometry.kind = GeometryKind::Solid;
  geometry.addRing({{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 0, 1}, {x, 0, 1}});
  geometry.finishSurface();
  geometry.shellStart = {0, 1};
  geometry.solidStart = {0, 1};
  return geometry;
}

Geometry surface(const std::string& lod, SurfaceType type = SurfaceType::Unknown) {
  Geometry geometry;
  geometry.lod = lod;
  geometry.addRing({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  geometry.finishSurface({type});
  return geometry;
}

CityObject object(ObjectType type, std::vector<Geometry> geometries, std::vector<CityObject> children = {}) {
  CityObject result;
  result.type = type;
  result.geometries = std::move(geometries);
  result.children = std::move(children);
  return result;
}

std::vector<std::string> lods(const CityObject& building) {
  std::vector<std::string> result;
  for (const Geometry& geometry : exteriorGeometry(building)) result.push_back(geometry.lod);
  return result;
}

using Lods = std::vector<std::string>;
constexpr ObjectType kBuilding = ObjectType::Building;
constexpr ObjectType kPart = ObjectType::BuildingPart;

TEST(Exterior, TakesTheFinestLod) {
  EXPECT_EQ(lods(object(kBuilding, {block("1", 0), block("2.2", 0), block("1.3", 0)})), Lods{"2.2"});
  EXPECT_EQ(lods(object(kBuilding, {block("lod2", 0), block("", 0)})), Lods{"lod2"});
}

TEST(Exterior, OutlinesCurvesAndPointsAreNothingToDraw) {
  Geometry curve = surface("3");
  curve.kind = GeometryKind::MultiCurve;
  EXPECT_TRUE(exteriorGeometry(object(kBuilding, {surface("0"), surface("0.3"), curve, Geometry{}})).empty());
}

TEST(Exterior, SolidsGoBeforeSurfacesOfTheSameLod) {
  const auto geometries = exteriorGeometry(object(kBuilding, {surface("2"), block("2", 0)}));
  ASSERT_EQ(geometries.size(), 1U);
  EXPECT_TRUE(geometries[0].isSolid());
}

TEST(Exterior, PartsAndInstallationsBelongRoomsDoNot) {
  const CityObject building =
      object(kBuilding, {block("2", 0)},
             {object(kPart, {block("2", 1)}, {object(kPart, {block("2", 2)})}),
              object(ObjectType::BuildingInstallation, {surface("3")}),
              object(ObjectType::BuildingRoom, {block("4", 0)}, {object(kPart, {block("4", 0)})})});
  EXPECT_EQ(lods(building), (Lods{"2", "2", "2", "3"}));
}

TEST(Exterior, CoarseShellGivesWayToFinerParts) {
  EXPECT_EQ(lods(object(kBuilding, {block("1", 0)},
                        {object(kPart, {block("2", 0)}), object(kPart, {block("1", 1)})})),
            (Lods{"2", "1"}));
  EXPECT_EQ(
      lods(object(kBuilding, {block("1", 0)}, {object(ObjectType::BuildingInstallation, {surface("2")})})),
      (Lods{"1", "2"}));
}

TEST(Exterior, InteriorSurfacesAreLeftOutWithTheirTextureCoordinates) {
  Geometry geometry;
  geometry.lod = "4";
  for (int i = 0; i < 3; ++i) {
    geometry.addRing({{0, 0, 1.0 * i}, {1, 0, 1.0 * i}, {1, 1, 1.0 * i}});
    geometry.finishSurface({i == 1 ? SurfaceType::InteriorWall : SurfaceType::Wall, i});
    for (int k = 0; k < 3; ++k) geometry.textureCoordinates.emplace_back(i, k);
  }
  const auto result = exteriorGeometry(object(kBuilding, {geometry}));
  ASSERT_EQ(result.size(), 1U);
  ASSERT_EQ(result[0].surfaceCount(), 2U);
  EXPECT_EQ(result[0].surfaces[1].material, 2);
  EXPECT_EQ(result[0].textureCoordinates.size(), 6U);
  EXPECT_EQ(result[0].textureCoordinates[3].x(), 2);
  EXPECT_EQ(result[0].vertices[result[0].ringVertices[3]].z(), 2);
}

}  // namespace
}  // namespace lodestone
