#include "model/perceive_options.h"

#include <numbers>

#include <gtest/gtest.h>

namespace lodestone {
namespace {

TEST(PerceiveOptions, PixelsPerDegreeComeFromTheDisplay) {
  PerceiveOptions options;
  // 1920 pixels over 0.53 m are 3622.6 a metre; a degree is 0.6 m · π / 180 = 10.47 mm wide.
  EXPECT_NEAR(options.pixelsPerDegree(), 37.94, 0.01);
  options.screenWidth = 2;
  options.screenResolution = 360;
  options.distance = 1;
  EXPECT_DOUBLE_EQ(options.pixelsPerDegree(), std::numbers::pi);
  options.distance = 10;
  EXPECT_DOUBLE_EQ(options.pixelsPerDegree(), 10 * std::numbers::pi);
}

TEST(PerceiveOptions, DefaultsAreWithinTheirRanges) {
  EXPECT_TRUE(check(PerceiveOptions{}).empty());
}

}  // namespace
}  // namespace lodestone
