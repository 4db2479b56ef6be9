#include "model/geometry.h"

#include <random>

#include <gmock/gmock.h>

#include "model/camera.h"
#include "model/city_model.h"

namespace lodestone {
namespace {

Ring square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

TEST(Geometry, AreaKeepsItsDigitsFarFromTheOrigin) {
  EXPECT_DOUBLE_EQ(signedArea(square(0, 0, 2)), 4);
  EXPECT_NEAR(signedArea(square(3.9e5, 5.8e6, 0.1)), 0.01, 1e-9);
  Ring reversed = square(0, 0, 2);
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_DOUBLE_EQ(signedArea(reversed), -4);
  EXPECT_DOUBLE_EQ(area(Polygon{square(0, 0, 10), {square(2, 2, 3)}}), 91);
}

TEST(Geometry, TidyRingDropsRepeatsAndTurns) {
  Ring ring = square(0, 0, 1);
  ring.insert(ring.begin() + 1, ring[0]);
  ring.push_back(ring[0]);
  tidyRing(ring, false);
  EXPECT_EQ(ring.size(), 4U);
  EXPECT_LT(signedArea(ring), 0);
}

// Every corner of the box must fall inside the picture, and the picture must not be mostly empty.
TEST(Camera, FitShowsTheWholeBoxFromAnyDirection) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int round = 0; round < 200; ++round) {
    Box3 box;
    box.add(Vec3(u(random) * 500, u(random) * 500, 0));
    box.add(Vec3(u(random) * 500, u(random) * 500, 50 * std::abs(u(random))));
    const Vec3 direction(u(random), u(random), -std::abs(u(random)) - 0.01);
    const Camera camera = fitCamera(box, direction, 45, 1280, 800);
    const CameraFrame frame = frameOf(camera);
    const double scale = camera.height / 2.0 / std::tan(camera.fov * M_PI / 360);
    double reach = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p((corner & 1) ? box.max.x() : box.min.x(), (corner & 2) ? box.max.y() : box.min.y(),
                   (corner & 4) ? box.max.z() : box.min.z());
      const Vec3 v = p - camera.eye;
      const double depth = v.dot(frame.forward);
      ASSERT_GT(depth, 0);
      const double x = std::abs(v.dot(frame.right) / depth * scale) / (camera.width / 2.0);
      const double y = std::abs(v.dot(frame.up) / depth * scale) / (camera.height / 2.0);
      ASSERT_LE(std::max(x, y), 1);
      reach = std::max({reach, x, y});
    }
    EXPECT_GT(reach, 0.5);
  }
}

TEST(Camera, StraightDownHasNorthUp) {
  Camera camera;
  camera.eye = Vec3(0, 0, 100);
  camera.target = Vec3::Zero();
  EXPECT_TRUE(frameOf(camera).up.isApprox(Vec3::UnitY()));
  EXPECT_TRUE(frameOf(camera).right.isApprox(Vec3::UnitX()));
}

}  // namespace
}  // namespace lodestone
