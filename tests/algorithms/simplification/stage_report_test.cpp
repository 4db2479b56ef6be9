// Cities simplified where people would not miss it, and what is reported of it.
#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "algorithms/simplification/city_simplification.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

bool tells(const Diagnostics& diagnostics, Code code) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [&](const Diagnostic& d) { return d.code == code; });
}

/// Two that stand apart, the first with a block inside that nobody sees.
std::shared_ptr<const CityModel> twoBuildings() {
  CityModel city = cityOfParts({bumpyBlock(4, {0, 0, 0}, 6, 1), bumpyBlock(2, {2, 2, 2}, 2, 2)});
  CityModel other = cityOfParts({bumpyBlock(3, {30, 0, 0}, 5, 3)});
  other.buildings.front().object.id = "other";
  city.buildings.push_back(other.buildings.front());
  return std::make_shared<const CityModel>(city);
}

constexpr PerceiveOptions kSmall{.views = 8, .size = 64, .slight = 0.02, .moderate = 0.2, .dramatic = 1};

TEST(StageReport, CountsEveryTriangleOnceAndHasTheRateOfTable2) {
  const auto city = twoBuildings();
  for (const SimplifyMethod method : {SimplifyMethod::Perception, SimplifyMethod::Combined}) {
    for (int stage = 1; stage <= 3; ++stage) {
      const auto result = simplifyCity(city, {.method = method, .rate = 1, .stage = stage}, {}, {}, kSmall);
      ASSERT_TRUE(result.ok());
      ASSERT_EQ(result->groups, 2U);
      const SimplifyReport& report = result->report;
      ASSERT_TRUE(report.stage);
      const auto& classes = report.stage->classes;
      EXPECT_EQ(std::accumulate(classes.begin(), classes.end(), report.stage->unseen),
                report.trianglesBefore);
      EXPECT_GE(report.stage->unseen, 48U);
      EXPECT_EQ(report.stage->latent(), classes[1] + classes[2] + classes[3]);
      EXPECT_EQ(report.stage->admitted, std::accumulate(classes.end() - stage, classes.end(), 0U));
      EXPECT_EQ(report.stage->removed, report.trianglesBefore - report.trianglesAfter);
      EXPECT_LE(report.stage->removed, report.stage->admitted);
      EXPECT_GT(report.stage->admitted, 0U);
      EXPECT_FALSE(tells(result.diagnostics, Code::RateNotMet));  // a rate of 1: until nothing is admitted
    }
  }
}

TEST(StageReport, WhatNobodySeesGoesWhereItIsAskedFor) {
  const auto city = twoBuildings();
  const auto components = [&](bool unseen) {
    const auto result =
        simplifyCity(city, {.method = SimplifyMethod::Perception, .rate = 1, .stage = 3, .unseen = unseen},
                     {}, {}, kSmall);
    return result->report.componentsAfter;
  };
  EXPECT_EQ(components(false), 3U);
  EXPECT_EQ(components(true), 2U);
}

TEST(StageReport, NothingAdmittedAndRatesThatAreNotMetAreTold) {
  const auto city = twoBuildings();
  PerceiveOptions blind = kSmall;
  blind.slight = blind.moderate = blind.dramatic = 255;
  const SimplifyOptions options{.method = SimplifyMethod::Perception, .rate = 0.9, .stage = 3};
  const auto nothing = simplifyCity(city, options, {}, {}, blind);
  EXPECT_EQ(nothing->report.trianglesAfter, nothing->report.trianglesBefore);
  EXPECT_TRUE(tells(nothing.diagnostics, Code::NothingAdmitted));
  EXPECT_FALSE(tells(nothing.diagnostics, Code::RateNotMet));
  const auto some = simplifyCity(city, options, {}, {}, kSmall);
  EXPECT_FALSE(tells(some.diagnostics, Code::NothingAdmitted));
  EXPECT_TRUE(tells(some.diagnostics, Code::RateNotMet));
}

}  // namespace
}  // namespace lodestone
