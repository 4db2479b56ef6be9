#include "algorithms/visibility.h"

#include <array>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "algorithms/simplification.h"
#include "algorithms/triangle_distance.h"

#include "part_models.h"

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

/// A panel 4 m wide and 3 m high with a rough front; its sides are toothed, and fit its neighbours'.
Faces toothedPanel(const Vec3& at, unsigned seed) {
  constexpr int kAcross = 12;
  constexpr int kUp = 12;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> bump(-0.3, 0.3);
  std::array<std::array<Vec3, kUp + 1>, kAcross + 1> front;
  std::array<std::array<Vec3, kUp + 1>, kAcross + 1> back;
  for (std::size_t i = 0; i <= kAcross; ++i) {
    for (std::size_t k = 0; k <= kUp; ++k) {
      const bool side = i == 0 || i == kAcross;
      const Vec3 place = at + Vec3(i / 3.0 + (side ? 0.2 * (k % 2) : 0), 0, 0.25 * k);
      front[i][k] = place + Vec3(0, side ? 0 : bump(random), 0);
      back[i][k] = place + Vec3(0, 0.4, 0);
    }
  }
  Faces faces;
  const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    faces.push_back({a, b, c});
    faces.push_back({a, c, d});
  };
  for (std::size_t i = 0; i < kAcross; ++i) {
    for (std::size_t k = 0; k < kUp; ++k) {
      quad(front[i][k], front[i + 1][k], front[i + 1][k + 1], front[i][k + 1]);
      quad(back[i + 1][k], back[i][k], back[i][k + 1], back[i + 1][k + 1]);
    }
    quad(front[i][0], back[i][0], back[i + 1][0], front[i + 1][0]);
    quad(front[i][kUp], front[i + 1][kUp], back[i + 1][kUp], back[i][kUp]);
  }
  for (std::size_t k = 0; k < kUp; ++k) {
    quad(front[0][k], front[0][k + 1], back[0][k + 1], back[0][k]);
    quad(front[kAcross][k], back[kAcross][k], back[kAcross][k + 1], front[kAcross][k + 1]);
  }
  return faces;
}

/// A block of flats of panels between floors, in the way as in figure 17; openings let targets show.
std::vector<Faces> panelledBlock() {
  std::vector<Faces> parts;
  unsigned seed = 1;
  for (int storey = 0; storey < 4; ++storey) {
    for (int bay = 0; bay < 8; ++bay) {
      if ((bay * 5 + storey * 3) % 11 == 0) continue;
      parts.push_back(toothedPanel(Vec3(4 * bay, 0, 3 * storey), seed++));
    }
  }
  for (int storey = 0; storey <= 4; ++storey)
    parts.push_back(boxFaces(Vec3(-0.5, -0.4, 3 * storey - 0.15), Vec3(32.8, 1, 3 * storey + 0.15)));
  return parts;
}

/// Twenty targets behind the block, in three rows.
OwnedTriangles twentyTargets() {
  OwnedTriangles scene;
  for (std::uint32_t i = 0; i < 20; ++i) {
    const double x = -8 + 7.0 * (i % 7);
    const double y = 12 + 10.0 * (i / 7);
    addBoxes({boxFaces(Vec3(x, y, 0), Vec3(x + 4, y + 4, 5 + 2.0 * (i % 3)))}, i, scene);
  }
  return scene;
}

TEST(Visibility, PastOurLevelIsThatPastTheOriginal) {
  const ComponentMesh block = meshOfParts(panelledBlock());
  const auto visible = [&](const ComponentMesh& model) {
    OwnedTriangles scene = twentyTargets();
    const auto first = static_cast<std::uint32_t>(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), model.vertices.begin(), model.vertices.end());
    for (const auto& [a, b, c] : model.triangles) {
      scene.triangles.push_back({first + a, first + b, first + c});
      scene.owner.push_back(kBlocked);
    }
    return lookFrom({Vec3(16, -25, 1.7), Vec3(0, 1, 0.1), 70, 90, 512, 256}, scene, 20);
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
