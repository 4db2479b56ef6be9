#include "algorithms/simplification/contacts.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "algorithms/geometry/triangle_distance.h"
#include "algorithms/simplification/city_simplification.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/deviation.h"
#include "algorithms/simplification/measured_simplification.h"
#include "algorithms/simplification/simplified_mesh.h"
#include "tests/support/part_models.h"

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

/// Greatest distance of points strewn over one mesh to all triangles of the other.
double strewnDistance(const ComponentMesh& from, const ComponentMesh& to, int steps) {
  double most = 0;
  for (const auto& [a, b, c] : from.triangles) {
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        const Vec3 p = from.vertices[a] + (from.vertices[b] - from.vertices[a]) * i / steps +
                       (from.vertices[c] - from.vertices[a]) * j / steps;
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [d, e, f] : to.triangles)
          least =
              std::min(least, (closestPoint({to.vertices[d], to.vertices[e], to.vertices[f]}, p) - p).norm());
        most = std::max(most, least);
      }
    }
  }
  return most;
}

TEST(Deviation, IsThatOfManyStrewnPoints) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    const ComponentMesh mesh =
        meshOfParts({bumpyBlock(3, {0, 0, 0}, 3, seed), boxFaces({2, 0, 0}, {7, 1, 2})});
    const ComponentMesh left = simplify(mesh, {.method = SimplifyMethod::Qem, .rate = 0.7}).mesh;
    const double accuracy = 0.001;
    const Deviation found = deviation(mesh, left, accuracy);
    EXPECT_NEAR(hausdorffDistance(mesh, left, accuracy), found.hausdorff(), accuracy);
    const int steps = 16;
    const double apart = 5.0 / steps;  // of strewn points, at most
    for (const auto& [strewn, exact] : {std::pair(strewnDistance(mesh, left, steps), found.forward),
                                        {strewnDistance(left, mesh, steps), found.backward}}) {
      EXPECT_GE(exact, strewn - accuracy);
      EXPECT_LE(exact, strewn + apart);
    }
  }
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

double gapOf(const std::vector<ContactReport>& contacts) {
  double widest = 0;
  for (const ContactReport& contact : contacts) widest = std::max(widest, contact.gap);
  return widest;
}

TEST(AutoCost, IsTheBestOfItsCurve) {
  const ComponentMesh mesh = meshOfParts({bumpyBlock(5, {0, 0, 0}, 5, 3), bumpyBlock(4, {4.5, 0, 0}, 4, 4)});
  const Classification classes = classify(mesh);
  const Measured found = simplifyAndMeasure(mesh, classes, {.rate = 0.7, .aAuto = true});
  ASSERT_EQ(found.trials.size(), 8U);
  EXPECT_EQ(found.trials.front().a, 1);
  EXPECT_EQ(found.trials.back().a, 8);
  const double diagonal = bounds(mesh).size().norm();
  for (const AutoTrial& trial : found.trials) {
    const Simplified one = simplify(mesh, {.rate = 0.7, .a = trial.a});
    EXPECT_EQ(trial.widestGap, gapOf(followContacts(mesh, classes, one)));
    EXPECT_EQ(trial.hausdorff, hausdorffDistance(mesh, one.mesh));
    EXPECT_DOUBLE_EQ(trial.score, (trial.widestGap + trial.hausdorff) / diagonal);
    EXPECT_EQ(trial.groups, trial.a == found.a ? 1U : 0U);
    EXPECT_GE(1.05 * trial.score, (found.hausdorff + gapOf(found.contacts)) / diagonal);
    if (trial.a != found.a) continue;
    EXPECT_EQ(found.simplified.mesh.triangles, one.mesh.triangles);
  }
}

TEST(AutoCost, TakesTheFewestBrokenContactsAmongScoresThatAreAllButEqual) {
  const auto best = [](std::vector<AutoTrial> trials) { return trials[bestTrial(trials)].a; };
  const auto trial = [](double a, double score, std::uint32_t separated, std::uint32_t lost) {
    return AutoTrial{.a = a, .separated = separated, .lost = lost, .score = score};
  };
  EXPECT_EQ(best({trial(1, 0.2, 0, 0), trial(2, 0.1, 9, 9), trial(3, 0.106, 0, 0)}), 2);
  EXPECT_EQ(best({trial(1, 0.1, 5, 5), trial(2, 0.104, 9, 0), trial(3, 0.1, 4, 6)}), 2);
  EXPECT_EQ(best({trial(1, 0.103, 2, 2), trial(2, 0.101, 4, 0), trial(3, 0.1, 0, 5)}), 2);
  EXPECT_EQ(best({trial(1, 0.1, 1, 0), trial(2, 0.1, 1, 0)}), 1);
  EXPECT_EQ(best({trial(1, 0, 3, 0), trial(2, 0, 1, 0), trial(3, 1e-9, 0, 0)}), 2);
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
