#include "model/sight_options.h"

#include <gtest/gtest.h>

namespace lodestone {
namespace {

TEST(SightOptions, HeadingsAreThoseOfACompass) {
  SightOptions sight;
  const std::pair<Vec3, double> directions[] = {{Vec3(0, 1, 0), 0},
                                                {Vec3(1, 0, 0), 90},
                                                {Vec3(0, -3, 0), 180},
                                                {Vec3(-1, 0, 0), 270},
                                                {Vec3(-1, 1, 0), 315}};
  for (const auto& [direction, heading] : directions) {
    sight.lookAlong(direction);
    EXPECT_NEAR(sight.heading, heading, 1e-9);
    EXPECT_NEAR(sight.tilt, 0, 1e-9);
    EXPECT_TRUE(sight.direction().isApprox(direction.normalized(), 1e-9));
  }
  sight.lookAlong(Vec3(0, 1, 1));
  EXPECT_NEAR(sight.tilt, 45, 1e-9);
  sight.lookAlong(Vec3(0, 0, -2));
  EXPECT_EQ(sight.tilt, -89);
  EXPECT_TRUE(check(sight).empty());
}

TEST(SightOptions, StandsOnItsFeetAndTurns) {
  SightOptions sight;
  EXPECT_FALSE(sight.placed);
  sight.standAt(Vec3(3, 4, 5));
  EXPECT_TRUE(sight.placed);
  EXPECT_EQ(sight.eye(), Vec3(3, 4, 6.7));
  sight.tilt = 10;
  sight.turnTo(Vec3(3, 0, 90));
  EXPECT_NEAR(sight.heading, 180, 1e-9);
  EXPECT_EQ(sight.tilt, 10);
  sight.turnTo(Vec3(3, 4, 90));
  EXPECT_NEAR(sight.heading, 180, 1e-9);  // straight above: stays
}

}  // namespace
}  // namespace lodestone
