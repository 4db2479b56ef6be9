#include "algorithms/perception/flip.h"

#include <cmath>
#include <fstream>
#include <numeric>
#include <random>
#include <sstream>
#include <stop_token>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "algorithms/perception/vector_math.h"
#include "tests/algorithms/perception/plain_flip.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

using Random = std::mt19937;

Picture plain(int width, int height, const std::array<int, 3>& colour) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    for (const int c : colour) picture.rgba.push_back(static_cast<std::uint8_t>(c));
    picture.rgba.push_back(255);
  }
  return picture;
}

Picture noise(int width, int height, Random& random) {
  Picture picture = plain(width, height, {0, 0, 0});
  for (auto& value : picture.rgba) value = static_cast<std::uint8_t>(random() % 256);
  return picture;
}

/// Blocks of colours, as façades have them.
Picture blocks(int width, int height, Random& random) {
  Picture picture = plain(width, height, {200, 180, 160});
  for (int n = 0; n < 6; ++n) {
    const int x0 = static_cast<int>(random()) % width;
    const int y0 = static_cast<int>(random() % static_cast<unsigned>(height));
    for (int y = y0; y < std::min(height, y0 + 5); ++y) {
      for (int x = std::abs(x0); x < std::min(width, std::abs(x0) + 4); ++x)
        for (int c = 0; c < 3; ++c)
          picture.rgba[4 * static_cast<std::size_t>(y * width + x) + static_cast<std::size_t>(c)] =
              static_cast<std::uint8_t>(40 * n + 10 * c);
    }
  }
  return picture;
}

/// The same with small changes.
Picture changed(Picture picture, Random& random) {
  for (auto& value : picture.rgba)
    if (random() % 3 == 0)
      value = static_cast<std::uint8_t>(std::min(255, value + static_cast<int>(random() % 12)));
  return picture;
}

void expectPlain(const Picture& a, const Picture& b, double pixelsPerDegree) {
  const FlipMap map = flip(a, b, pixelsPerDegree);
  const test::PlainFlip expected(a, b, pixelsPerDegree);
  double sum = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const double error = expected.error(x, y);
      // Where colours are all but equal and features are not, floats tell least: 1e-9 to the 0.35th is 7e-4.
      ASSERT_NEAR(map.errors[static_cast<std::size_t>(y * a.width + x)], error, 2e-3)
          << x << " " << y << " of " << a.width << " x " << a.height << " at " << pixelsPerDegree;
      sum += error;
    }
  }
  EXPECT_NEAR(map.mean, sum / (a.width * a.height), 1e-4);
}

TEST(Flip, EqualsWhatThePaperWritesDown) {
  Random random(4);
  for (const double pixelsPerDegree : {3.0, 12.0, 30.0, 67.0}) {
    const Picture facade = blocks(19, 14, random);
    expectPlain(facade, blocks(19, 14, random), pixelsPerDegree);
    expectPlain(facade, changed(facade, random), pixelsPerDegree);
    expectPlain(noise(9, 11, random), noise(9, 11, random), pixelsPerDegree);
  }
}

Picture cropped(const Picture& from, int x0, int y0, int width, int height) {
  Picture picture = plain(width, height, {0, 0, 0});
  for (int y = 0; y < height; ++y) {
    const auto* row = &from.rgba[4 * static_cast<std::size_t>((y0 + y) * from.width + x0)];
    std::copy_n(row, 4 * width, &picture.rgba[4 * static_cast<std::size_t>(y * width)]);
  }
  return picture;
}

/// Letters, icons and a city: the workbench moved by one pixel.
TEST(Flip, EqualsItOnARealPicture) {
  const auto picture = readPicture(LODESTONE_SOURCE_DIR "/resources/docs/workbench.png");
  ASSERT_TRUE(picture.ok());
  Random random(7);
  for (int i = 0; i < 4; ++i) {
    const int x = static_cast<int>(random() % static_cast<unsigned>(picture->width - 30));
    const int y = static_cast<int>(random() % static_cast<unsigned>(picture->height - 30));
    expectPlain(cropped(*picture, x, y, 16, 12), cropped(*picture, x + 1, y, 16, 12), 67);
  }
}

/// Where a filter is wider than the picture, most of it meets the border.
TEST(Flip, EqualsItForPicturesNarrowerThanTheFilters) {
  Random random(9);
  for (const auto& [width, height] :
       std::vector<std::pair<int, int>>{{1, 1}, {1, 9}, {9, 1}, {2, 2}, {7, 5}}) {
    for (const double pixelsPerDegree : {2.0, 67.0, 350.0})
      expectPlain(noise(width, height, random), noise(width, height, random), pixelsPerDegree);
  }
}

TEST(Flip, AgreesWithTheAuthorsProgram) {
  const auto folder = test::sharedRoot() / "reference" / "flip";
  std::ifstream table(folder / "values.csv");
  if (!table) GTEST_SKIP() << "no " << folder;
  std::string line;
  std::getline(table, line);
  int pairs = 0;
  while (std::getline(table, line)) {
    std::istringstream fields(line);
    std::string reference;
    std::string test;
    double pixelsPerDegree = 0;
    double mean = 0;
    char comma = 0;
    std::getline(fields, reference, ',');
    std::getline(fields, test, ',');
    fields >> pixelsPerDegree >> comma >> mean;
    const auto a = readPicture(folder / reference);
    const auto b = readPicture(folder / test);
    ASSERT_TRUE(a.ok() && b.ok()) << line;
    EXPECT_NEAR(flip(*a, *b, pixelsPerDegree).mean, mean, 1e-4) << line;  // asked for: 5e-4
    ++pairs;
  }
  EXPECT_EQ(pairs, 12);
}

TEST(Flip, EqualPicturesHaveNoErrorWhateverTheirAlpha) {
  Random random(2);
  const Picture a = noise(40, 30, random);
  Picture b = a;
  for (std::size_t i = 3; i < b.rgba.size(); i += 4) b.rgba[i] = 7;
  const FlipMap map = flip(a, b, 67);
  EXPECT_EQ(map.mean, 0);
  EXPECT_EQ(map.errors, std::vector<float>(1200, 0));
}

TEST(Flip, LiesBetweenNothingAndOneAndDoesNotAskWhichIsTheReference) {
  Random random(3);
  const std::vector<Picture> pictures{plain(24, 20, {0, 0, 0}),    plain(24, 20, {255, 255, 255}),
                                      plain(24, 20, {0, 255, 0}),  plain(24, 20, {0, 0, 255}),
                                      noise(24, 20, random),       blocks(24, 20, random),
                                      plain(24, 20, {255, 0, 255})};
  for (const Picture& a : pictures) {
    for (const Picture& b : pictures) {
      const FlipMap map = flip(a, b, 67);
      for (const float error : map.errors) ASSERT_TRUE(error >= 0 && error <= 1) << error;
      EXPECT_EQ(map.errors, flip(b, a, 67).errors);
      EXPECT_EQ(map.mean > 0.1, &a != &b);
    }
  }
  EXPECT_NEAR(flip(pictures[2], pictures[3], 67).mean, 1, 1e-5);  // the largest difference there is
}

TEST(Flip, FineNoiseIsSeenLessFromFartherAway) {
  Random random(6);
  const Picture a = plain(60, 60, {128, 128, 128});
  const Picture b = changed(a, random);
  double before = 1;
  for (const double pixelsPerDegree : {10.0, 30.0, 67.0, 130.0}) {
    const double mean = flip(a, b, pixelsPerDegree).mean;
    EXPECT_LT(mean, before) << pixelsPerDegree;
    before = mean;
  }
}

TEST(Flip, AnyNumberOfPixelsPerDegreeIsFast) {
  Random random(8);
  const Picture a = noise(30, 20, random);
  const Picture b = noise(30, 20, random);
  for (const double pixelsPerDegree : {0.001, 0.5, 1e4, 1e6}) {
    for (const float error : flip(a, b, pixelsPerDegree).errors)
      ASSERT_TRUE(error >= 0 && error <= 1) << pixelsPerDegree;
  }
}

TEST(Flip, TheSameForAnyNumberOfThreads) {
  Random random(5);
  const Picture a = noise(700, 300, random);
  const Picture b = changed(a, random);
  FlipMap first;
  for (const int threads : {1, 2, 8}) {
    const tbb::global_control workers(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    const FlipMap map = arena.execute([&] { return flip(a, b, 67); });
    if (first.errors.empty()) first = map;
    EXPECT_TRUE(map.errors == first.errors) << threads;
    EXPECT_EQ(map.mean, first.mean) << threads;
  }
  EXPECT_NEAR(first.mean, std::accumulate(first.errors.begin(), first.errors.end(), 0.0) / 210000, 1e-9);
}

TEST(Flip, StopsWhenAsked) {
  Random random(5);
  const Picture a = noise(64, 64, random);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)flip(a, a, 67, Progress({}, source.get_token())), Cancelled);
  EXPECT_TRUE(flip({}, {}, 67).errors.empty());
}

TEST(FlipPicture, IsBrighterWhereTheErrorIsLarger) {
  FlipMap map{101, 1, {}, 0};
  for (int i = 0; i <= 100; ++i) map.errors.push_back(static_cast<float>(i) / 100);
  const Picture picture = flipPicture(map);
  ASSERT_EQ(picture.rgba.size(), 404U);
  double before = -1;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    const auto* p = &picture.rgba[i];
    const double luminance = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
    EXPECT_GT(luminance, before) << i;
    before = luminance;
    EXPECT_EQ(p[3], 255);
  }
  EXPECT_LT(picture.rgba[0] + picture.rgba[1] + picture.rgba[2], 10);
  EXPECT_GT(before, 240);
}

TEST(PixelError, CountsPixelsThatDifferInAnyChannel) {
  const Picture a = plain(10, 10, {9, 9, 9});
  Picture b = a;
  EXPECT_EQ(pixelError(a, b), 0);
  b.rgba[0] ^= 1;
  b.rgba[1] ^= 1;
  b.rgba[4 * 7 + 2] ^= 64;
  EXPECT_DOUBLE_EQ(pixelError(a, b), 0.02);
  EXPECT_EQ(pixelError(a, plain(10, 10, {8, 9, 9})), 1);
  EXPECT_EQ(pixelError({}, {}), 0);
}

TEST(VectorMath, IsWhatTheLibraryComputes) {
  Random random(1);
  std::uniform_real_distribution<double> exponents(-19, 19);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const auto x = static_cast<float>(std::pow(10, exponents(random)));
    const auto power = static_cast<float>(unit(random));
    EXPECT_NEAR(cubeRoot(x) / std::cbrt(static_cast<double>(x)), 1, 3e-7) << x;
    EXPECT_NEAR(raised(x, power) / std::pow(static_cast<double>(x), static_cast<double>(power)), 1, 1e-5)
        << x;
    const auto share = static_cast<float>(unit(random));
    EXPECT_NEAR(raised(share, power), std::pow(static_cast<double>(share), static_cast<double>(power)), 2e-6);
  }
  EXPECT_EQ(raised(0, 0.5F), 0);
  EXPECT_NEAR(raised(1, 0.3F), 1, 1e-7);
}

}  // namespace
}  // namespace lodestone
