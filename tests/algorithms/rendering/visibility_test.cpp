#include "algorithms/rendering/visibility.h"

#include <algorithm>
#include <array>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "algorithms/geometry/triangle_distance.h"
#include "algorithms/simplification/simplification.h"
#include "tests/support/blocked_view.h"

namespace lodestone {
namespace {

/// Distance along the ray to the triangle (Möller and Trumbore), or infinity.
double hitAt(const Vec3& along, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 p = along.cross(v);
  const double det = u.dot(p);
  if (std::abs(det) < 1e-12) return std::numeric_limits<double>::infinity();
  const double s = -a.dot(p) / det;
  const Vec3 q = (-a).cross(u);
  const double t = along.dot(q) / det;
  const double distance = v.dot(q) / det;
  const bool hit = s >= 0 && t >= 0 && s + t <= 1 && distance > 0;
  return hit ? distance : std::numeric_limits<double>::infinity();
}

/// Each pixel against each triangle.
std::vector<std::uint32_t> referencePicture(const Viewpoint& from, const OwnedTriangles& scene) {
  const Vec3 forward = from.direction.normalized();
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  const Vec3 up = right.cross(forward);
  const double half = std::tan(from.angle * std::numbers::pi / 360);
  std::vector<std::uint32_t> who;
  for (int y = 0; y < from.height; ++y) {
    for (int x = 0; x < from.width; ++x) {
      const Vec3 along = (forward + right * ((2 * x + 1.0) / from.width - 1) * half +
                          up * (from.height - 2 * y - 1.0) / from.width * half)
                             .normalized();
      double nearest = from.distance;
      std::uint32_t owner = kNobody;
      for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
        const auto& [a, b, c] = scene.triangles[t];
        const double distance = hitAt(along, scene.vertices[a] - from.eye, scene.vertices[b] - from.eye,
                                      scene.vertices[c] - from.eye);
        if (distance > nearest) continue;
        nearest = distance;
        owner = scene.owner[t];
      }
      who.push_back(owner);
    }
  }
  return who;
}

void addBoxes(const std::vector<Faces>& parts, std::uint32_t owner, OwnedTriangles& scene) {
  addBuildings(
      cityOfParts(parts), [&](std::uint32_t) { return owner; }, scene);
}

OwnedTriangles randomScene(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-20, 20);
  std::uniform_real_distribution<double> size(1, 6);
  OwnedTriangles scene;
  for (std::uint32_t i = 0; i < 12; ++i) {
    const Vec3 at(place(random), 25 + place(random), 0);
    addBoxes({boxFaces(at, at + Vec3(size(random), size(random), size(random)))}, i < 9 ? i : kBlocked,
             scene);
  }
  return scene;
}

TEST(Visibility, IsThatOfTheBruteForceCaster) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const OwnedTriangles scene = randomScene(seed);
    const Viewpoint from{Vec3(0.3, -3.1, 1.7), Vec3(0.1, 1, 0.02), 70, 40, 64, 40};
    const Sighting sighting = lookFrom(from, scene, 9);
    const std::vector<std::uint32_t> reference = referencePicture(from, scene);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) differ += reference[i] != sighting.who[i] ? 1 : 0;
    EXPECT_LE(differ, 2U) << "boxes that cross each other, or end at the distance, in single precision";
  }
}

TEST(Visibility, HasTheSamePixelsForAnyNumberOfThreads) {
  const OwnedTriangles scene = randomScene(3);
  const auto look = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return lookFrom({Vec3(0, -3, 2), Vec3::UnitY(), 80, 100, 300, 200}, scene, 9).who;
  };
  EXPECT_EQ(look(1), look(2));
  EXPECT_EQ(look(1), look(5));
}

TEST(Visibility, EndsAtItsDistance) {
  OwnedTriangles scene;
  addBoxes({boxFaces({-1, 10, 0}, {1, 11, 4})}, 0, scene);
  addBoxes({boxFaces({3, 30, 0}, {5, 31, 4})}, 1, scene);
  Viewpoint from{Vec3(0, 0, 2), Vec3::UnitY(), 60, 20, 200, 100};
  EXPECT_EQ(lookFrom(from, scene, 2).sees(1), false);
  from.distance = 40;
  EXPECT_EQ(lookFrom(from, scene, 2).sees(0), true);
  EXPECT_EQ(lookFrom(from, scene, 2).sees(1), true);
}

TEST(Visibility, OfTwoSightingsNamesWhatDiffers) {
  OwnedTriangles open;
  addBoxes({boxFaces({-1, 10, 0}, {1, 11, 4})}, 0, open);
  OwnedTriangles blocked = open;
  addBoxes({boxFaces({-5, 5, 0}, {5, 6, 9})}, kBlocked, blocked);
  const Viewpoint from{Vec3(0, 0, 2), Vec3::UnitY(), 60, 100, 100, 50};
  const Sighting seen = lookFrom(from, open, 1);
  const Sighting hidden = lookFrom(from, blocked, 1);
  EXPECT_EQ(seenOnlyIn(seen, hidden), std::vector<std::uint32_t>{0});
  EXPECT_TRUE(seenOnlyIn(hidden, seen).empty());
  const Picture picture = identityPicture(seen, hidden);
  const std::size_t middle = 4 * (25 * 100 + 50);
  EXPECT_EQ(picture.rgba[middle], 214);  // red: not seen in the other
}

TEST(Visibility, StreetsAreCoarserTheFartherTheyAre) {
  EXPECT_DOUBLE_EQ(streetRate(0), 0);
  EXPECT_DOUBLE_EQ(streetRate(1.0 / 3), 0.3);
  EXPECT_DOUBLE_EQ(streetRate(2.0 / 3), 0.7);
  EXPECT_DOUBLE_EQ(streetRate(1), 0.95);
  EXPECT_DOUBLE_EQ(streetRate(7), 0.95);
  EXPECT_NEAR(streetRate(0.5), 0.5, 1e-12);
}

OwnedTriangles twentyTargets() {
  OwnedTriangles scene;
  for (std::uint32_t i = 0; i < kTargets; ++i) addBoxes({targetFaces(i)}, i, scene);
  return scene;
}

TEST(Visibility, AFootprintStandsAsItsBlock) {
  CityModel city = cityOfParts({boxFaces({-1, 10, 0}, {1, 11, 4})});
  Building& block = city.buildings.emplace_back();
  block.footprint = {{{{3, 10}, {5, 10}, {5, 11}, {3, 11}}, {}}};
  block.base = 1;
  block.height = 3;
  city.buildings.emplace_back();  // nothing at all
  OwnedTriangles scene;
  addBuildings(
      city, [](std::uint32_t building) { return building; }, scene);
  ASSERT_EQ(scene.owner.size(), scene.triangles.size());
  EXPECT_EQ(std::count(scene.owner.begin(), scene.owner.end(), 1U), 12);
  EXPECT_TRUE(lookFrom({Vec3(0, 0, 2), Vec3::UnitY(), 60, 20, 200, 100}, scene, 3).sees(1));
  const std::array<std::uint32_t, 1> one{1};
  OwnedTriangles alone;
  addBuildings(
      city, one, [](std::uint32_t building) { return building + 7; }, alone);
  EXPECT_EQ(alone.owner, std::vector<std::uint32_t>(12, 8));
}

TEST(Visibility, PastOurLevelIsThatPastTheOriginal) {
  const ComponentMesh block = meshOfParts(panelledBlock());
  const auto visible = [&](const ComponentMesh& model) {
    OwnedTriangles scene = twentyTargets();
    addMesh(model, kBlocked, scene);
    return lookFrom({Vec3(16, -25, 1.7), Vec3(0, 1, 0.1), 70, 90, 1024, 512}, scene, 20);
  };
  const Sighting original = visible(block);
  const auto report = [&](const char* name, const Sighting& sighting) {
    std::size_t seen = 0;
    for (std::uint32_t t = 0; t < 20; ++t) seen += sighting.sees(t) ? 1 : 0;
    std::printf("%-18s %2zu of 20 visible, %zu appeared, %zu vanished\n", name, seen,
                seenOnlyIn(sighting, original).size(), seenOnlyIn(original, sighting).size());
    return seen;
  };
  const std::size_t seen = report("original", original);
  EXPECT_GT(seen, 4U);
  EXPECT_LT(seen, 16U);
  const Sighting ours =
      visible(simplify(block, {.method = SimplifyMethod::Topology, .rate = 0.8, .a = 8}).mesh);
  const Sighting plain = visible(simplify(block, {.method = SimplifyMethod::Qem, .rate = 0.8}).mesh);
  report("topology, 80%", ours);
  report("qem, 80%", plain);
  EXPECT_TRUE(seenOnlyIn(ours, original).empty());
  EXPECT_TRUE(seenOnlyIn(original, ours).empty());
  EXPECT_GT(seenOnlyIn(plain, original).size(), 0U);
}

}  // namespace
}  // namespace lodestone
