#include "algorithms/perception/viewpoints.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace lodestone {
namespace {

const Box3 kHouse{Vec3(100, 200, 30), Vec3(112, 208, 39)};

Vec3 towards(const Camera& camera) {
  return (camera.target - camera.eye).normalized();
}

/// Whether a point is in the picture.
bool shows(const Camera& camera, const Vec3& p) {
  const CameraFrame frame = frameOf(camera);
  const Vec3 to = p - camera.eye;
  const double half = std::tan(camera.fov * std::numbers::pi / 360) * to.dot(frame.forward);
  return to.dot(frame.forward) > 0 && std::abs(to.dot(frame.up)) <= half &&
         std::abs(to.dot(frame.right)) <= half * camera.width / camera.height;
}

class Viewpoints : public testing::TestWithParam<ViewpointSet> {};

void expectWholeModel(const Camera& camera, const Box3& box) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) != 0 ? box.max.x() : box.min.x(), (corner & 2) != 0 ? box.max.y() : box.min.y(),
                 (corner & 4) != 0 ? box.max.z() : box.min.z());
    EXPECT_TRUE(shows(camera, p)) << box.size().transpose();
  }
}

TEST_P(Viewpoints, ShowTheWholeModelInSquarePictures) {
  PerceiveOptions options;
  options.viewpoints = GetParam();
  options.size = 333;
  for (const Vec3& size : {Vec3(12, 8, 9), Vec3(20, 20, 60), Vec3(20, 20, 100), Vec3(300, 4, 12),
                           Vec3(5, 5, 400), Vec3(80, 60, 0.5), Vec3(0.1, 0.2, 0.3)}) {
    const Box3 box{kHouse.min, kHouse.min + size};
    const auto cameras = viewpointsAround(box, options);
    ASSERT_EQ(cameras.size(), 26U);
    for (const Camera& camera : cameras) {
      EXPECT_EQ(camera.width, 333);
      EXPECT_EQ(camera.height, 333);
      expectWholeModel(camera, box);
    }
  }
}

TEST_P(Viewpoints, AreOthersWhenTurned) {
  PerceiveOptions options;
  options.viewpoints = GetParam();
  const auto some = viewpointsAround(kHouse, options);
  const auto others = viewpointsAround(kHouse, options, 0.5);
  for (const Camera& camera : some) {
    for (const Camera& other : others) EXPECT_GT((camera.eye - other.eye).norm(), 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Viewpoints,
                         testing::Values(ViewpointSet::Sphere, ViewpointSet::Upper, ViewpointSet::Street));

TEST(ViewpointSets, SpreadEvenlyOverTheSphere) {
  PerceiveOptions options;
  const auto cameras = viewpointsAround(kHouse, options);
  Vec3 sum = Vec3::Zero();
  for (const Camera& camera : cameras) sum += towards(camera);
  EXPECT_LT((sum / 26).norm(), 0.05);
  for (const Camera& camera : cameras) {
    double nearest = 180;
    for (const Camera& other : cameras) {
      if (&other != &camera)
        nearest = std::min(nearest, std::acos(std::clamp(towards(camera).dot(towards(other)), -1.0, 1.0)) *
                                        180 / std::numbers::pi);
    }
    EXPECT_GT(nearest, 20);
    EXPECT_LT(nearest, 50);
  }
}

TEST(ViewpointSets, UpperLooksDownAndStreetStandsAtEyeHeight) {
  PerceiveOptions options;
  options.viewpoints = ViewpointSet::Upper;
  for (const Camera& camera : viewpointsAround(kHouse, options)) EXPECT_LT(towards(camera).z(), 0);
  options.viewpoints = ViewpointSet::Street;
  for (const Camera& camera : viewpointsAround(kHouse, options))
    EXPECT_DOUBLE_EQ(camera.eye.z(), kHouse.min.z() + 1.7);
}

TEST(ViewpointSets, AreNoneAroundNothingAndSomewhereAroundAPoint) {
  EXPECT_TRUE(viewpointsAround(Box3(), {}).empty());
  const Box3 point{Vec3(5, 5, 5), Vec3(5, 5, 5)};
  for (const Camera& camera : viewpointsAround(point, {})) {
    EXPECT_TRUE(camera.eye.allFinite());
    EXPECT_GT((camera.target - camera.eye).norm(), 0);
  }
}

}  // namespace
}  // namespace lodestone
