#include "algorithms/rendering/rendering.h"

#include <cmath>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>
#include <png.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "tests/support/chains.h"

namespace lodestone {
namespace {

LodLevel levelOf(std::vector<LevelObject> objects) {
  LodLevel level;
  level.objectCount = objects.size();
  level.object = [objects = std::move(objects)](std::size_t i) { return objects[i]; };
  return level;
}

/// Houses that share walls and overlap, so that many triangles are hit at the same distance.
LodLevel crowdedTown() {
  std::vector<LevelObject> objects;
  std::mt19937 random(3);
  for (int i = 0; i < 1200; ++i) {
    const double x = 8.0 * static_cast<int>(random() % 40);
    const double y = 8.0 * static_cast<int>(random() % 40);
    objects.push_back(
        test::blockObject("b", test::square(x, y, 8 + 8 * (random() % 2)), random() % 3, 4 + random() % 12));
    objects.back().role = static_cast<DrawRole>(random() % 3);
  }
  return levelOf(std::move(objects));
}

Camera smallCamera(const Vec3& eye, const Vec3& target) {
  Camera camera;
  camera.eye = eye;
  camera.target = target;
  camera.width = 160;
  camera.height = 100;
  return camera;
}

std::array<int, 3> pixel(const Picture& picture, int x, int y) {
  const auto* p = &picture.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                     static_cast<std::size_t>(x))];
  return {p[0], p[1], p[2]};
}

bool isBluish(const std::array<int, 3>& p) {
  return p[2] > p[0] + 12;
}

TEST(Render, TheSamePixelsForAnyNumberOfThreads) {
  const LodLevel level = crowdedTown();
  const Camera camera = smallCamera({-100, -150, 120}, {160, 160, 0});
  std::vector<std::uint8_t> first;
  for (int threads : {1, 2, 8}) {
    const tbb::global_control workers(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    const Picture picture = arena.execute([&] { return renderLevel(level, camera); });
    if (first.empty()) first = picture.rgba;
    EXPECT_TRUE(picture.rgba == first) << threads;
  }
}

TEST(Render, SilhouetteOfABoxIsWhereItShouldBe) {
  // Straight down from 100 m on a blue cube of 20 m: its roof, at 80 m, is as wide as the tangent says.
  LevelObject cube = test::blockObject("c", test::square(-10, -10, 20), 0, 20);
  cube.role = DrawRole::Cluster;
  Camera camera = smallCamera({0, 0, 100}, {0, 0, 0});
  camera.height = 160;
  const Picture picture = renderLevel(levelOf({cube}), camera);
  const double half = 80 * 10 / (80 * std::tan(camera.fov * M_PI / 360));
  int blue = 0;
  for (int x = 0; x < camera.width; ++x) blue += isBluish(pixel(picture, x, 80)) ? 1 : 0;
  EXPECT_NEAR(blue, 2 * half, 2);
  blue = 0;
  for (int y = 0; y < camera.height; ++y) blue += isBluish(pixel(picture, 80, y)) ? 1 : 0;
  EXPECT_NEAR(blue, 2 * half, 2);
}

TEST(Render, ShadowsFallToTheNorthEast) {
  const LodLevel level = levelOf({test::blockObject("c", test::square(-5, -5, 10), 0, 20)});
  Camera camera = smallCamera({0, 0, 300}, {0, 0, 0});
  camera.fov = 15;
  const Picture picture = renderLevel(level, camera);
  const auto brightness = [&](int dx, int dy) {
    const auto p = pixel(picture, 80 + dx, 50 - dy);
    return p[0] + p[1] + p[2];
  };
  EXPECT_LT(brightness(13, 13) + 60, brightness(-13, -13));
}

TEST(Render, EmptyLevelIsGroundAndSky) {
  const Picture picture = renderLevel(levelOf({}), smallCamera({0, 0, 10}, {100, 0, 10}));
  EXPECT_NE(pixel(picture, 80, 2), pixel(picture, 80, 97));
  EXPECT_TRUE(bounds(levelOf({})).empty());
}

TEST(Render, FromInsideABuildingOnlyItsWallsAreSeen) {
  LevelObject house = test::blockObject("c", test::square(-5, -5, 10), 0, 10);
  house.role = DrawRole::Cluster;
  const Picture picture = renderLevel(levelOf({house}), smallCamera({0, 0, 5}, {5, 1, 5}));
  for (int x = 0; x < 160; x += 10) EXPECT_TRUE(isBluish(pixel(picture, x, 50)));
}

TEST(Render, BoundsAreThoseOfTheGeometry) {
  const Box3 box = bounds(levelOf({test::blockObject("a", test::square(10, 20, 5), 2, 8),
                                   test::blockObject("b", test::square(-10, 0, 5), 1, 2)}));
  EXPECT_EQ(box.min, Vec3(-10, 0, 1));
  EXPECT_EQ(box.max, Vec3(15, 25, 10));
}

TEST(Picture, IsWrittenAsPngAndReadBack) {
  Picture picture{3, 2, {}};
  for (int i = 0; i < 24; ++i) picture.rgba.push_back(static_cast<std::uint8_t>(i * 10));
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "lodestone-picture.png";
  ASSERT_TRUE(writePicture(picture, path).ok());
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0);
  image.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> back(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, back.data(), 0, nullptr), 0);
  EXPECT_EQ(image.width, 3U);
  EXPECT_EQ(back, picture.rgba);
  std::filesystem::remove(path);
}

TEST(Picture, BadOnesAndOtherEndingsAreRefused) {
  EXPECT_EQ(writePicture(Picture{}, "a.png").diagnostics[0].code, Code::OutputUnwritable);
  EXPECT_EQ(writePicture(Picture{1, 1, {0, 0, 0, 0}}, "a.docx").diagnostics[0].code,
            Code::OutputFormatUnknown);
  EXPECT_NE(whyNoPicture("a.docx")->text.find(".jpg"), std::string::npos);
  EXPECT_FALSE(whyNoPicture("a.JPG"));
  EXPECT_EQ(writePicture(Picture{1, 1, {0, 0, 0, 0}}, "/proc/none/a.png").diagnostics[0].code,
            Code::OutputUnwritable);
}

}  // namespace
}  // namespace lodestone
