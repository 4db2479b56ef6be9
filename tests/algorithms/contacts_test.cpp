#include "algorithms/contacts.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "algorithms/city_simplification.h"
#include "algorithms/classification.h"
#include "algorithms/deviation.h"
#include "algorithms/simplified_mesh.h"

#include "part_models.h"

namespace lodestone {
namespace {

const std::vector<Faces> kTower{boxFaces({0, 0, 0}, {10, 10, 1}), boxFaces({3, 3, 1}, {5, 5, 4}),
                                boxFaces({6, 6, 1}, {8, 8, 4})};

/// The mesh without the components that are not `kept`.
Simplified only(const ComponentMesh& mesh, const std::vector<bool>& kept) {
  std::vector<bool> left;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) left.push_back(kept[componentOfTriangle(mesh, t)]);
  return keepTriangles(mesh, mesh.vertices, mesh.triangles, mesh.textureCoordinates, left);
}

TEST(Contacts, OfAnUntouchedModelAreKept) {
  const ComponentMesh mesh = meshOfParts(kTower);
  const Classification classes = classify(mesh);
  const auto reports = followContacts(mesh, classes, only(mesh, {true, true, true}));
  ASSERT_EQ(reports.size(), 2U);
  for (const ContactReport& report : reports) EXPECT_EQ(report.fate, ContactFate::Kept);
  EXPECT_NEAR(reports[0].at.z(), 1, 1e-9);
}

TEST(Contacts, WithAComponentThatIsGoneAreLost) {
  const ComponentMesh mesh = meshOfParts(kTower);
  const auto reports = followContacts(mesh, classify(mesh), only(mesh, {true, false, true}));
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].fate, ContactFate::Lost);
  EXPECT_EQ(reports[1].fate, ContactFate::Kept);
}

TEST(Contacts, OfWhatMovedAwayAreSeparatedByTheirGap) {
  const ComponentMesh mesh = meshOfParts(kTower);
  Simplified moved = only(mesh, {true, true, true});
  const Component& column = moved.mesh.components[1];
  for (std::uint32_t v = column.firstVertex; v < column.endVertex(); ++v) moved.mesh.vertices[v].z() += 0.25;
  const auto reports = followContacts(mesh, classify(mesh), moved);
  EXPECT_EQ(reports[0].fate, ContactFate::Separated);
  EXPECT_NEAR(reports[0].gap, 0.25, 1e-12);
  EXPECT_EQ(reports[1].fate, ContactFate::Kept);
}

TEST(Contacts, OfWhatSankIntoTheOtherAreKept) {
  const ComponentMesh mesh =
      meshOfParts({boxFaces({0, 0, 0}, {10, 10, 10}), boxFaces({3, 3, 10}, {5, 5, 14})});
  Simplified moved = only(mesh, {true, true});
  const Component& column = moved.mesh.components[1];
  for (std::uint32_t v = column.firstVertex; v < column.endVertex(); ++v) moved.mesh.vertices[v].z() -= 7;
  EXPECT_EQ(followContacts(mesh, classify(mesh), moved)[0].fate, ContactFate::Kept);
}

TEST(Deviation, OfAMovedBoxIsHowFarItMoved) {
  const ComponentMesh box = meshOfParts({boxFaces({0, 0, 0}, {4, 4, 4})});
  const ComponentMesh higher = meshOfParts({boxFaces({0, 0, 0}, {4, 4, 5})});
  EXPECT_EQ(deviation(box, box).hausdorff(), 0);
  EXPECT_NEAR(deviation(box, higher).forward, 1, 1e-12);
  EXPECT_NEAR(deviation(box, higher).backward, 1, 1e-12);
}

TEST(Deviation, DiffersByDirectionWhereAPartIsMissing) {
  const ComponentMesh both = meshOfParts({boxFaces({0, 0, 0}, {1, 1, 1}), boxFaces({5, 0, 0}, {6, 1, 1})});
  const ComponentMesh one = meshOfParts({boxFaces({0, 0, 0}, {1, 1, 1})});
  EXPECT_NEAR(deviation(both, one).forward, 5, 1e-12);
  EXPECT_NEAR(deviation(both, one).backward, 0, 1e-12);
}

/// Houses wall to wall, and one that stands alone.
CityModel rowOfHouses() {
  CityModel city;
  for (const double x : {0.0, 5.0, 10.0, 40.0}) {
    city.buildings.push_back(cityOfParts({boxFaces({x, 0, 0}, {x + 5, 8, 6})}).buildings.front());
    city.buildings.back().object.id = "house-" + std::to_string(city.buildings.size());
  }
  return city;
}

TEST(CitySimplification, HousesThatTouchAreOneModel) {
  const auto groups = touchingBuildings(rowOfHouses());
  EXPECT_EQ(groups, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {3}}));
}

TEST(CitySimplification, IsTheSameForAnyNumberOfThreads) {
  const auto city = std::make_shared<const CityModel>(rowOfHouses());
  const auto run = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    std::vector<Vec3> vertices;
    const Result<SimplifiedCity> result = simplifyCity(city, {.rate = 0.3});
    for (const Building& building : result->city->buildings)
      forEachObject(building.object, [&](const CityObject& object) {
        for (const Geometry& geometry : object.geometries)
          vertices.insert(vertices.end(), geometry.vertices.begin(), geometry.vertices.end());
      });
    return vertices;
  };
  EXPECT_EQ(run(1), run(2));
}

TEST(CitySimplification, WithRateZeroEveryTriangleStays) {
  const Result<SimplifiedCity> result =
      simplifyCity(std::make_shared<const CityModel>(rowOfHouses()), {.rate = 0});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->report.trianglesAfter, 48U);
  EXPECT_EQ(result->report.count(ContactFate::Kept), 2U);
  EXPECT_EQ(result->groups, 2U);
  EXPECT_EQ(result->buildingsGone, 0U);
}

}  // namespace
}  // namespace lodestone
