#include "algorithms/perception/hvs_filter.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "algorithms/perception/contrast_sensitivity.h"
#include "tests/support/plain_filter.h"

namespace lodestone {
namespace {

template <class Grey>
GreyImage picture(int width, int height, const Grey& grey) {
  GreyImage image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.pixels.push_back(static_cast<float>(grey(x, y)));
  return image;
}

GreyImage randomPicture(int width, int height, std::mt19937& random) {
  std::uniform_real_distribution<double> grey(0, 255);
  return picture(width, height, [&](int, int) { return grey(random); });
}

PerceiveOptions seenFrom(double distance) {
  PerceiveOptions options;
  options.distance = distance;
  return options;
}

double weight(int level, bool diagonal, const PerceiveOptions& options) {
  return bandWeight(level, diagonal, options.pixelsPerDegree(), options.csf);
}

TEST(HvsFilter, EqualsTheFiltersThemselves) {
  std::mt19937 random(3);
  const std::pair<int, int> sizes[] = {{1, 1}, {1, 70}, {53, 1}, {64, 64}, {67, 41}, {30, 97}};
  for (const auto& [width, height] : sizes) {
    for (const double distance : {0.2, 0.6, 3.0, 30.0}) {
      const GreyImage image = randomPicture(width, height, random);
      const GreyImage seen = filterAsSeen(image, seenFrom(distance));
      const std::vector<double> expected = plainlyFiltered(image, seenFrom(distance));
      ASSERT_EQ(seen.pixels.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_NEAR(seen.pixels[i], expected[i], 1e-3);
    }
  }
}

TEST(HvsFilter, NearEyesSeeEverything) {
  std::mt19937 random(4);
  const GreyImage image = randomPicture(70, 90, random);
  EXPECT_EQ(filterAsSeen(image, seenFrom(0.05)).pixels, image.pixels);
}

TEST(HvsFilter, KeepsWhatIsEven) {
  const GreyImage image = picture(75, 50, [](int, int) { return 180; });
  for (const double distance : {0.3, 0.6, 5.0, 100.0})
    for (const float pixel : filterAsSeen(image, seenFrom(distance)).pixels) EXPECT_NEAR(pixel, 180, 1e-3);
}

TEST(HvsFilter, WeakensTheFinestGratingsByTheirBandsWeight) {
  for (const double distance : {0.4, 0.6, 1.0}) {
    const PerceiveOptions options = seenFrom(distance);
    const auto sign = [](int i) { return i % 2 == 0 ? 1 : -1; };
    const GreyImage stripes =
        filterAsSeen(picture(41, 52, [&](int x, int) { return 100 + 50 * sign(x); }), options);
    const GreyImage board =
        filterAsSeen(picture(41, 52, [&](int x, int y) { return 100 + 50 * sign(x + y); }), options);
    for (int i = 0; i < 41 * 52; ++i) {
      const int x = i % 41;
      const int y = i / 41;
      const auto place = static_cast<std::size_t>(i);
      ASSERT_NEAR(stripes.pixels[place], 100 + 50 * sign(x) * weight(1, false, options), 1e-3);
      ASSERT_NEAR(board.pixels[place], 100 + 50 * sign(x + y) * weight(1, true, options), 1e-3);
    }
  }
}

double rootOfMeanSquare(const GreyImage& a, const GreyImage& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) squares += std::pow(a.pixels[i] - b.pixels[i], 2);
  return std::sqrt(squares / static_cast<double>(a.pixels.size()));
}

TEST(HvsFilter, FartherEyesSeeLess) {
  std::mt19937 random(5);
  const GreyImage image = randomPicture(128, 128, random);
  double lost = 0;
  for (const double distance : {0.3, 0.6, 1.2, 2.4, 4.8, 9.6}) {
    const double now = rootOfMeanSquare(image, filterAsSeen(image, seenFrom(distance)));
    EXPECT_GT(now, lost);
    lost = now;
  }
  EXPECT_GT(lost, 60);  // of 73.6 in all
}

TEST(HvsFilter, TouchesEdgesAlone) {
  const GreyImage image = picture(256, 64, [](int x, int) { return x < 128 ? 50 : 200; });
  const GreyImage seen = filterAsSeen(image, seenFrom(0.6));
  double largest = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const int x = static_cast<int>(i % 256);
    const double difference = std::abs(image.pixels[i] - seen.pixels[i]);
    if (std::abs(x - 128) > 40) {
      EXPECT_LT(difference, 1e-3) << x;
    }
    largest = std::max(largest, difference);
  }
  EXPECT_GT(largest, 1);
}

TEST(HvsFilter, TakesAnEmptyPicture) {
  EXPECT_TRUE(filterAsSeen(GreyImage{}, {}).pixels.empty());
}

}  // namespace
}  // namespace lodestone
