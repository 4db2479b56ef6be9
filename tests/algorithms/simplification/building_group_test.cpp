// One building of a city with those that it touches, out of the city and back into one of their own.
#include <algorithm>
#include <atomic>

#include <gtest/gtest.h>

#include "algorithms/simplification/city_classification.h"
#include "algorithms/simplification/city_simplification.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/simplification.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

/// A row of three houses, wall to wall, one farther off whose box they do not meet, and one whose box meets
/// the row's though it stands apart.
CityModel street() {
  CityModel city;
  const auto add = [&](const Faces& faces) {
    CityModel one = cityOfParts({faces});
    one.buildings.front().object.id = "house-" + std::to_string(city.buildings.size());
    city.buildings.push_back(one.buildings.front());
  };
  for (int i = 0; i < 3; ++i) add(boxFaces({10.0 * i, 0, 0}, {10.0 * i + 10, 8, 6}));
  add(boxFaces({100, 0, 0}, {110, 8, 6}));
  add({{{5, 8, 0}, {5, 20, 0}, {-20, 20, 0}}, {{5, 8.5, 6}, {5, 20, 6}, {-20, 20, 6}}});
  city.materials.emplace_back().name = "brick";
  city.origin = Vec3(4, 5, 6);
  return city;
}

TEST(TouchingGroup, IsTheGroupOfAllGroupsThatTheBuildingIsIn) {
  const CityModel city = street();
  const auto groups = touchingBuildings(city);
  ASSERT_GE(groups.size(), 2U);
  for (std::uint32_t b = 0; b < city.buildings.size(); ++b) {
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return std::find(group.begin(), group.end(), b) != group.end();
    });
    ASSERT_NE(found, groups.end());
    EXPECT_EQ(touchingGroup(city, b), *found) << b;
  }
  EXPECT_EQ(touchingGroup(city, 3), std::vector<std::uint32_t>{3});
}

TEST(SimplifiedCity, TellsTheGroupsOnceBeforeWorkOnAnyOfThemBegins) {
  const auto city = std::make_shared<const CityModel>(street());
  std::vector<std::vector<std::uint32_t>> told;
  std::atomic<bool> tooLate = false;
  const auto rate = [&](const auto&) {
    if (told.empty()) tooLate = true;
    return 0.2;
  };
  const auto known = [&](const auto& groups) { told.insert(told.end(), groups.begin(), groups.end()); };
  ASSERT_TRUE(simplifyCity(city, {}, {}, rate, {}, known).ok());
  EXPECT_EQ(told, touchingBuildings(*city));
  EXPECT_FALSE(tooLate);
}

TEST(SimplifiedBuildings, AreACityOfTheirOwnWithWhatIsLeft) {
  const CityModel city = street();
  const std::vector<std::uint32_t> group{1, 2};
  const ComponentMesh mesh = makeComponentMesh(city, group);
  SimplifyOptions options;
  options.rate = 0.4;
  const Simplified simplified = simplify(mesh, options);
  const CityModel made = simplifiedBuildings(city, group, simplified.mesh);
  ASSERT_EQ(made.buildings.size(), 2U);
  EXPECT_EQ(made.buildings[0].object.id, "house-1");
  EXPECT_EQ(made.buildings[1].object.id, "house-2");
  EXPECT_EQ(made.materials.size(), 1U);
  EXPECT_EQ(made.origin, city.origin);
  const std::vector<std::uint32_t> all{0, 1};
  EXPECT_EQ(makeComponentMesh(made, all).triangleCount(), simplified.mesh.triangleCount());
}

/// Two row houses with a wing each that share a wall, one with no height, and one with surfaces.
CityModel footprints() {
  CityModel city;
  for (const double x : {0.0, 10.0, 50.0}) {
    Building building;
    building.object.id = "footprint-" + std::to_string(city.buildings.size());
    building.footprint = {{{{x, 0}, {x + 10, 0}, {x + 10, 8}, {x + 4, 8}, {x + 4, 14}, {x, 14}}, {}}};
    building.base = 2;
    building.height = x < 50 ? 6 : 0;
    city.buildings.push_back(building);
  }
  city.buildings.push_back(cityOfParts({boxFaces({100, 0, 0}, {110, 8, 6})}).buildings.front());
  return city;
}

TEST(SimplifiedBuildings, AFootprintStandsAsItsBlock) {
  const auto city = std::make_shared<const CityModel>(footprints());
  const std::vector<std::uint32_t> all{0, 1, 2, 3};
  const ComponentMesh mesh = makeComponentMesh(*city, all);
  ASSERT_EQ(mesh.components.size(), 3U);
  EXPECT_EQ(mesh.triangleCount(), 20U + 20U + 12U);
  EXPECT_EQ(mesh.objects[1].id, "footprint-1");
  EXPECT_EQ(bounds(mesh).min.z(), 0);
  EXPECT_EQ(bounds(mesh, mesh.components[0]).max.z(), 8);
  EXPECT_EQ(touchingGroup(*city, 1), (std::vector<std::uint32_t>{0, 1}));
  const Result<SimplifiedCity> result = simplifyCity(city, {.rate = 0.3});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->report.trianglesBefore, 52U);
  EXPECT_LE(result->report.trianglesAfter, 36U);
  ASSERT_EQ(result->city->buildings.size(), 4U);
  EXPECT_EQ(makeComponentMesh(*result->city, all).triangleCount(), result->report.trianglesAfter);
  EXPECT_EQ(result->city->buildings[0].object.geometries.front().lod, "1.2");
  EXPECT_TRUE(result->city->buildings[2].object.geometries.empty());
}

TEST(ClassifyCity, ClassifiesEachGroupAsIfItWereAlone) {
  CityModel city = street();
  // a slab with a post through it, of centimetres, kilometres away: as one model all its points would be one
  CityModel far = cityOfParts(
      {boxFaces({0, 0, 0}, {0.02, 0.02, 0.002}), boxFaces({0.005, 0.005, -0.01}, {0.01, 0.01, 0.01})});
  for (CityObject& part : far.buildings.front().object.children) {
    for (Geometry& geometry : part.geometries) {
      for (Vec3& p : geometry.vertices) p += Vec3(20000, 0, 0);
    }
  }
  city.buildings.insert(city.buildings.begin() + 1, far.buildings.front());
  const Result<ClassifiedCity> all = classifyCity(city, 0.01);
  ASSERT_TRUE(all.ok());
  std::uint32_t vertex = 0;
  std::uint32_t component = 0;
  std::size_t edge = 0;
  std::size_t contact = 0;
  for (const auto& group : touchingBuildings(city)) {
    const ComponentMesh mesh = makeComponentMesh(city, group);
    const Classification classes = classify(mesh, 0.01);
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v, ++vertex) {
      EXPECT_EQ(all->mesh.vertices[vertex], mesh.vertices[v]);
      EXPECT_EQ(all->classes.vertices[vertex], classes.vertices[v]);
      EXPECT_EQ(all->classes.planeCount(vertex), classes.planeCount(v));
    }
    for (const BoundaryEdge& own : classes.edges) {
      const BoundaryEdge& found = all->classes.edges[edge++];
      EXPECT_EQ(all->mesh.vertices[found.from], mesh.vertices[own.from]);
      EXPECT_EQ(found.other, component + own.other);
      EXPECT_EQ(componentOfTriangle(all->mesh, found.triangles.front()), found.other);
    }
    for (const auto& [a, b] : classes.contacts)
      EXPECT_EQ(all->classes.contacts[contact++], std::pair(component + a, component + b));
    for (const Component& own : mesh.components) {
      const ComponentMesh::SourceObject& found = all->mesh.objects[all->mesh.components[component++].object];
      EXPECT_EQ(found.building, group[mesh.objects[own.object].building]);
      EXPECT_EQ(found.id, mesh.objects[own.object].id);
    }
  }
  EXPECT_EQ(vertex, all->mesh.vertexCount());
  EXPECT_EQ(edge, all->classes.edges.size());
  EXPECT_EQ(contact, all->classes.contacts.size());
  EXPECT_GT(contact, 2U);
}

}  // namespace
}  // namespace lodestone
