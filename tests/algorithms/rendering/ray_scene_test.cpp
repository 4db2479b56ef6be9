#include "algorithms/rendering/ray_scene.h"

#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace lodestone {
namespace {

/// Rays against every triangle in turn: exact enough to count as the truth for boxes.
double nearestByForce(const TriangleSoup& soup, const Ray& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  const Vec3 o = ray.origin.cast<double>();
  const Vec3 d = ray.direction.cast<double>();
  for (const auto& t : soup.triangles) {
    const Vec3 a = soup.vertices[t[0]].cast<double>();
    const Vec3 e1 = soup.vertices[t[1]].cast<double>() - a;
    const Vec3 e2 = soup.vertices[t[2]].cast<double>() - a;
    const Vec3 p = d.cross(e2);
    const double det = e1.dot(p);
    if (std::abs(det) < 1e-12) continue;
    const Vec3 s = o - a;
    const double u = s.dot(p) / det;
    const Vec3 q = s.cross(e1);
    const double v = d.dot(q) / det;
    const double t0 = e2.dot(q) / det;
    if (u >= -1e-9 && v >= -1e-9 && u + v <= 1 + 1e-9 && t0 > 0) nearest = std::min(nearest, t0);
  }
  return nearest;
}

TriangleSoup randomSoup(std::mt19937& random) {
  TriangleSoup soup;
  std::uniform_real_distribution<float> unit(-1, 1);
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Vec3f center(10 * unit(random), 10 * unit(random), 10 * unit(random));
    for (int k = 0; k < 3; ++k)
      soup.vertices.emplace_back(center + Vec3f(unit(random), unit(random), unit(random)) * 3);
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

TEST(RayScene, FindsWhatTryingEveryTriangleFinds) {
  std::mt19937 random(1);
  const TriangleSoup soup = randomSoup(random);
  std::uniform_real_distribution<float> unit(-1, 1);
  const RayScene scene(soup);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{Vec3f(20 * unit(random), 20 * unit(random), 20),
                  Vec3f(unit(random), unit(random), -2).normalized()};
    const double expected = nearestByForce(soup, ray);
    const auto hit = scene.closest(ray);
    ASSERT_EQ(hit.has_value(), std::isfinite(expected));
    EXPECT_EQ(scene.occluded(ray), hit.has_value());
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(hit->distance, expected, 1e-3);
  }
  EXPECT_GT(hits, 200);
}

/// From one place, a little apart, as those of a pixel are, or further.
RayBundle randomBundle(std::mt19937& random) {
  std::uniform_real_distribution<float> unit(-1, 1);
  const Vec3f origin(20 * unit(random), 20 * unit(random), 20);
  const Vec3f along(unit(random), unit(random), -2);
  const float apart = random() % 2 == 0 ? 0.01F : 0.5F;
  RayBundle bundle;
  for (Ray& ray : bundle) {
    ray.origin = origin;
    ray.direction = (along + apart * Vec3f(unit(random), unit(random), unit(random))).normalized();
    if (random() % 3 == 0) ray.farthest = 20 + 5 * unit(random);
  }
  return bundle;
}

TEST(RayScene, RaysBesideEachOtherFindWhatEachAloneFinds) {
  std::mt19937 random(2);
  TriangleSoup soup = randomSoup(random);
  // Each triangle twice: of the two the later one is to be found.
  const auto once = static_cast<std::uint32_t>(soup.triangles.size());
  for (std::uint32_t t = 0; t < once; ++t) soup.triangles.push_back(soup.triangles[t]);
  const RayScene scene(soup);
  int hits = 0;
  int mixed = 0;
  for (int i = 0; i < 2000; ++i) {
    const RayBundle bundle = randomBundle(random);
    const auto found = scene.closestOfEach(bundle);
    const auto occluded = scene.occludedEach(bundle);
    int own = 0;
    for (std::size_t k = 0; k < bundle.size(); ++k) {
      const auto alone = scene.closest(bundle[k]);
      ASSERT_EQ(found[k].has_value(), alone.has_value());
      EXPECT_EQ(occluded[k], alone.has_value());
      if (!alone) continue;
      ++own;
      EXPECT_EQ(found[k]->triangle, alone->triangle);
      EXPECT_GE(found[k]->triangle, once);
      EXPECT_EQ(found[k]->distance, alone->distance);
    }
    hits += own;
    mixed += own > 0 && own < 4 ? 1 : 0;
  }
  EXPECT_GT(hits, 800);
  EXPECT_GT(mixed, 100);
}

TEST(RayScene, OfCoincidentTrianglesTheLastIsHit) {
  TriangleSoup soup;
  soup.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  for (int i = 0; i < 100; ++i) soup.triangles.push_back({0, 1, 2});
  const RayScene scene(soup);
  for (float x = 0.1F; x < 3; x += 0.1F) {
    const auto hit = scene.closest({{x, 0.5F, 5}, {0, 0, -1}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->triangle, 99U);
  }
}

TEST(RayScene, WithoutTrianglesNothingIsHit) {
  const RayScene scene(TriangleSoup{});
  EXPECT_FALSE(scene.closest({{0, 0, 1}, {0, 0, -1}}).has_value());
  EXPECT_FALSE(scene.occluded({{0, 0, 1}, {0, 0, -1}}));
}

}  // namespace
}  // namespace lodestone
