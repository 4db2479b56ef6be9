// assignFootprints() on bodies made by hand.
#include <gtest/gtest.h>

#include "algorithms/footprints/footprints.h"

namespace lodestone {
namespace {

using Face = std::vector<Vec3>;

void addSurface(Geometry& geometry, const Face& face, SurfaceType type = SurfaceType::Unknown) {
  geometry.addRing(face);
  geometry.finishSurface({type});
}

/// A closed box; with types, its surfaces say what they are.
Geometry box(const Vec3& low, const Vec3& high, const std::string& lod, bool typed) {
  Geometry geometry;
  geometry.lod = lod;
  geometry.kind = GeometryKind::Solid;
  const auto at = [&](int x, int y, int z) {
    return Vec3(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
  };
  const auto type = [typed](SurfaceType t) { return typed ? t : SurfaceType::Unknown; };
  addSurface(geometry, {at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)}, type(SurfaceType::Ground));
  addSurface(geometry, {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)}, type(SurfaceType::Roof));
  addSurface(geometry, {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}, type(SurfaceType::Wall));
  addSurface(geometry, {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)}, type(SurfaceType::Wall));
  addSurface(geometry, {at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1)}, type(SurfaceType::Wall));
  addSurface(geometry, {at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1)}, type(SurfaceType::Wall));
  return geometry;
}

Building building(std::vector<Geometry> geometries) {
  Building result;
  result.object.id = "b";
  result.object.type = ObjectType::Building;
  result.object.geometries = std::move(geometries);
  return result;
}

CityObject part(std::vector<Geometry> geometries) {
  CityObject object;
  object.type = ObjectType::BuildingPart;
  object.geometries = std::move(geometries);
  return object;
}

struct Assigned {
  Building building;
  Diagnostics diagnostics;
};

Assigned assigned(Building given, const ImportOptions& options = {}) {
  CityModel model;
  model.buildings.push_back(std::move(given));
  Diagnostics diagnostics = assignFootprints(model, options);
  return {std::move(model.buildings[0]), std::move(diagnostics)};
}

std::vector<Code> codes(const Diagnostics& diagnostics) {
  std::vector<Code> result;
  for (const Diagnostic& d : diagnostics) result.push_back(d.code);
  return result;
}

TEST(AssignFootprints, GroundSurfaceAndGeometryGiveFootprintBaseAndHeight) {
  const auto [b, diagnostics] = assigned(building({box({0, 0, 30}, {4, 5, 37}, "2", true)}));
  EXPECT_DOUBLE_EQ(area(b.footprint), 20);
  EXPECT_DOUBLE_EQ(b.base, 30);
  EXPECT_DOUBLE_EQ(b.height, 7);
  EXPECT_EQ(b.heightSource, HeightSource::Geometry);
  EXPECT_TRUE(diagnostics.empty());
}

TEST(AssignFootprints, WithoutGroundTheOutlineIsTakenAndSaid) {
  const auto [b, diagnostics] = assigned(building({box({0, 0, 0}, {4, 5, 3}, "1", false)}));
  ASSERT_EQ(b.footprint.size(), 1U);
  EXPECT_EQ(b.footprint[0].outer, (Ring{Vec2(0, 0), Vec2(4, 0), Vec2(4, 5), Vec2(0, 5)}));
  EXPECT_EQ(codes(diagnostics), std::vector{Code::FootprintFromOutline});
}

TEST(AssignFootprints, OutlineOfAnOpenRoofHasNoSeams) {
  Geometry roof;
  roof.lod = "2";
  addSurface(roof, {Vec3(0, 0, 3), Vec3(4, 0, 3), Vec3(4, 2, 5), Vec3(0, 2, 5)}, SurfaceType::Roof);
  addSurface(roof, {Vec3(0, 2, 5), Vec3(4, 2, 5), Vec3(4, 4, 3), Vec3(0, 4, 3)}, SurfaceType::Roof);
  const auto [b, diagnostics] = assigned(building({roof}));
  ASSERT_EQ(b.footprint.size(), 1U);
  EXPECT_EQ(b.footprint[0].outer.size(), 4U);
  EXPECT_DOUBLE_EQ(area(b.footprint), 16);
}

TEST(AssignFootprints, PartsAreUnitedAndACoarseEnvelopeIsIgnored) {
  Building whole = building({box({-5, -5, 0}, {20, 20, 9}, "1", false)});
  whole.object.children.push_back(part({box({0, 0, 0}, {2, 2, 3}, "2", true)}));
  whole.object.children.push_back(part({box({2, 0, 1}, {5, 2, 8}, "2", true)}));
  const auto [b, diagnostics] = assigned(std::move(whole));
  ASSERT_EQ(b.footprint.size(), 1U);
  EXPECT_EQ(b.footprint[0].outer.size(), 4U);
  EXPECT_DOUBLE_EQ(area(b.footprint), 10);
  EXPECT_DOUBLE_EQ(b.base, 0);
  EXPECT_DOUBLE_EQ(b.height, 8);
}

TEST(AssignFootprints, DisjointPartsGiveTwoPolygonsAndPartsWithoutGroundTheirOutline) {
  Building whole = building({});
  whole.object.children.push_back(part({box({0, 0, 0}, {2, 2, 3}, "2", true)}));
  whole.object.children.push_back(part({box({10, 0, 0}, {12, 2, 3}, "2", false)}));
  const auto [b, diagnostics] = assigned(std::move(whole));
  EXPECT_EQ(b.footprint.size(), 2U);
  EXPECT_DOUBLE_EQ(area(b.footprint), 8);
}

TEST(AssignFootprints, FinestLodThatShowsTheOutsideIsTaken) {
  const std::vector<Geometry> all{box({0, 0, 0}, {1, 1, 1}, "0", true), box({0, 0, 0}, {2, 2, 2}, "1", true),
                                  box({0, 0, 0}, {3, 3, 3}, "3", true),
                                  box({0, 0, 0}, {2, 2, 4}, "2.2", true),
                                  box({0, 0, 0}, {5, 5, 5}, "4", true)};
  EXPECT_DOUBLE_EQ(assigned(building(all)).building.height, 3);
  EXPECT_DOUBLE_EQ(area(assigned(building({all[1], all[4]})).building.footprint), 25);
  EXPECT_DOUBLE_EQ(area(assigned(building({all[0], all[1]})).building.footprint), 4);
}

TEST(AssignFootprints, InteriorSurfacesDoNotCount) {
  Geometry rooms = box({0, 0, 0}, {4, 4, 3}, "4", false);
  addSurface(rooms, {Vec3(-9, -9, 1), Vec3(9, -9, 1), Vec3(9, 9, 1), Vec3(-9, 9, 1)}, SurfaceType::Floor);
  EXPECT_DOUBLE_EQ(area(assigned(building({rooms})).building.footprint), 16);
}

TEST(AssignFootprints, FlatOutlineTakesItsHeightFromAttributes) {
  Geometry plan;
  plan.lod = "0";
  addSurface(plan, {Vec3(0, 0, 12), Vec3(3, 0, 12), Vec3(3, 3, 12), Vec3(0, 3, 12)});
  Building b = building({plan});
  b.object.attributes.set("measuredHeight", 8.5);
  const Assigned measured = assigned(b);
  EXPECT_DOUBLE_EQ(measured.building.height, 8.5);
  EXPECT_DOUBLE_EQ(measured.building.base, 12);
  EXPECT_EQ(measured.building.heightSource, HeightSource::Attribute);

  b.object.attributes = {};
  b.object.attributes.set("storeysAboveGround", std::int64_t{4});
  ImportOptions options;
  options.floorHeight = 2.5;
  EXPECT_DOUBLE_EQ(assigned(b, options).building.height, 10);

  b.object.attributes = {};
  const Assigned unknown = assigned(b);
  EXPECT_DOUBLE_EQ(unknown.building.height, ImportOptions{}.defaultHeight);
  EXPECT_EQ(codes(unknown.diagnostics), (std::vector{Code::FootprintFromOutline, Code::HeightMissing}));
}

TEST(AssignFootprints, HeightsOfZeroOrLessAreRefused) {
  Building b = building({});
  b.footprint = {{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)}, {}}};
  b.object.attributes.set("height", -3.0);
  const auto [result, diagnostics] = assigned(b);
  EXPECT_EQ(result.heightSource, HeightSource::Default);
  EXPECT_EQ(codes(diagnostics), std::vector{Code::HeightNotPositive});
}

TEST(AssignFootprints, HeightsAreUnderstoodAsThoseOfFootprints) {
  Building b = building({});
  b.footprint = {{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)}, {}}};
  b.object.attributes.set("measuredHeight", std::string("12,5 m"));
  EXPECT_DOUBLE_EQ(assigned(b).building.height, 12.5);
  b.object.attributes.set("measuredHeight", std::string("hoch"));
  const auto [result, diagnostics] = assigned(b);
  EXPECT_EQ(result.heightSource, HeightSource::Default);
  ASSERT_EQ(codes(diagnostics), std::vector{Code::HeightNotUnderstood});
  EXPECT_NE(diagnostics[0].text.find("measuredheight \"hoch\""), std::string::npos);
}

TEST(AssignFootprints, GivenFootprintsAreKeptOrRepaired) {
  Building b = building({});
  b.heightSource = HeightSource::Constant;
  b.height = 5;
  b.footprint = {{{Vec2(0, 0), Vec2(1, 0), Vec2(2, 0), Vec2(2, 2), Vec2(0, 2)}, {}}};  // one vertex on a side
  const Assigned kept = assigned(b);
  EXPECT_EQ(kept.building.footprint[0].outer, b.footprint[0].outer);
  EXPECT_TRUE(kept.diagnostics.empty());

  b.footprint = {{{Vec2(0, 0), Vec2(2, 2), Vec2(2, 0), Vec2(0, 2)}, {}}};
  const Assigned bowTie = assigned(b);
  EXPECT_EQ(bowTie.building.footprint.size(), 2U);
  EXPECT_EQ(codes(bowTie.diagnostics), std::vector{Code::FootprintRepaired});

  b.footprint = {{{Vec2(0, 0), Vec2(1, 1), Vec2(2, 2)}, {}}};
  EXPECT_EQ(codes(assigned(b).diagnostics), std::vector{Code::FootprintMissing});
}

TEST(AssignFootprints, NothingToShowIsSaid) {
  const auto [b, diagnostics] = assigned(building({}));
  EXPECT_TRUE(b.footprint.empty());
  EXPECT_EQ(codes(diagnostics), (std::vector{Code::FootprintMissing, Code::HeightMissing}));
}

TEST(AssignFootprints, StopsWhenAsked) {
  CityModel model;
  model.buildings.resize(10);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)assignFootprints(model, {}, Progress({}, stop.get_token())), Cancelled);
}

TEST(AssignFootprints, GivesABuildingOfInstallationsTheHullOfAllOfThem) {
  // As an imported mesh comes: nothing but groups.
  CityModel city;
  CityObject& object = city.buildings.emplace_back().object;
  object.id = "mesh";
  for (const auto& [low, high] :
       {std::pair(Vec3(0, 0, 1), Vec3(4, 4, 3)), std::pair(Vec3(2, 2, 2), Vec3(8, 8, 9))}) {
    CityObject part;
    part.type = ObjectType::BuildingInstallation;
    part.geometries.push_back(box(low, high, "3", false));
    object.children.push_back(part);
  }
  (void)assignFootprints(city, {});
  const Building& building = city.buildings.front();
  ASSERT_EQ(building.footprint.size(), 1U);
  // (0,0) (4,0) (8,2) (8,8) (2,8) (0,4)
  EXPECT_NEAR(area(building.footprint), 64 - 4 - 4, 1e-9);
  EXPECT_DOUBLE_EQ(building.base, 1);
  EXPECT_DOUBLE_EQ(building.height, 8);
  EXPECT_EQ(building.heightSource, HeightSource::Geometry);
}

}  // namespace
}  // namespace lodestone
