#include "model/perception.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace lodestone {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

void expectWithin(float greyLevels, int bin) {
  ASSERT_GE(bin, 0);
  ASSERT_LT(bin, kDifferenceBins);
  EXPECT_LE(binBegin(bin), greyLevels);
  if (greyLevels < 256) {
    EXPECT_LT(greyLevels, binBegin(bin + 1));
  }
}

TEST(DifferenceBins, BeginWhereTheySay) {
  EXPECT_EQ(binBegin(0), 0);
  EXPECT_EQ(binBegin(16), 1);
  EXPECT_EQ(binBegin(kDifferenceBins), 256);
  for (int bin = 0; bin < kDifferenceBins; ++bin) {
    const auto begin = static_cast<float>(binBegin(bin));
    EXPECT_EQ(differenceBin(begin), bin);
    EXPECT_EQ(differenceBin(std::nextafter(begin, kInfinity)), bin);
    if (bin > 0) {
      EXPECT_EQ(differenceBin(std::nextafter(begin, 0.F)), bin - 1);
    }
  }
}

TEST(DifferenceBins, HoldEveryDifference) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> root(0, 16);
  int last = 0;
  for (float grey = 1e-6F; grey < 300; grey *= 1.0001F) {
    const int bin = differenceBin(grey);
    expectWithin(grey, bin);
    EXPECT_GE(bin, last);
    last = bin;
  }
  for (int i = 0; i < 100'000; ++i) {
    const float grey = root(random) * root(random);
    expectWithin(grey, differenceBin(grey));
  }
}

TEST(DifferenceBins, TakeWhatIsNoDifference) {
  EXPECT_EQ(differenceBin(-1), 0);
  EXPECT_EQ(differenceBin(-0.F), 0);
  EXPECT_EQ(differenceBin(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(differenceBin(std::numeric_limits<float>::max()), kDifferenceBins - 1);
  EXPECT_EQ(differenceBin(kInfinity), kDifferenceBins - 1);
}

TEST(DifferenceCuts, DivideTheBins) {
  DifferenceClasses classes;
  EXPECT_EQ(classes.of(kDifferenceBins - 1), DetailClass::None);
  classes.cuts = {10, 20, 20};
  EXPECT_EQ(classes.of(9), DetailClass::None);
  EXPECT_EQ(classes.of(10), DetailClass::Slight);
  EXPECT_EQ(classes.of(19), DetailClass::Slight);
  EXPECT_EQ(classes.of(20), DetailClass::Dramatic);
}

TEST(DetailClass, HasAName) {
  EXPECT_STREQ(toString(DetailClass::None), "none");
  EXPECT_STREQ(toString(DetailClass::Slight), "slight");
  EXPECT_STREQ(toString(DetailClass::Moderate), "moderate");
  EXPECT_STREQ(toString(DetailClass::Dramatic), "dramatic");
}

/// One triangle of each class that is seen, and one of each that is not.
Perception ofAllClasses() {
  Perception perception;
  for (std::size_t k = 0; k < 2 * kDetailClasses; ++k) {
    perception.classes.push_back(static_cast<DetailClass>(k % kDetailClasses));
    perception.pixels.push_back(k < kDetailClasses ? 1 : 0);
  }
  return perception;
}

TEST(AdmittedTriangles, AreThoseOfTheStage) {
  const Perception perception = ofAllClasses();
  using Admitted = std::vector<bool>;
  EXPECT_EQ(admittedTriangles(perception, 1, false), (Admitted{0, 0, 0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(admittedTriangles(perception, 2, false), (Admitted{0, 0, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(admittedTriangles(perception, 3, false), (Admitted{0, 1, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(admittedTriangles(perception, 1, true), (Admitted{0, 0, 0, 1, 1, 1, 1, 1}));
}

TEST(DetailCounts, AreThoseOfTheTrianglesThatAStageAdmits) {
  Perception perception = ofAllClasses();
  for (const auto detail : {DetailClass::Slight, DetailClass::Slight, DetailClass::Dramatic}) {
    perception.classes.push_back(detail);
    perception.pixels.push_back(7);
  }
  const DetailCounts counts = countDetail(perception);
  EXPECT_EQ(counts.seen, (std::array<std::uint32_t, kDetailClasses>{1, 3, 1, 2}));
  EXPECT_EQ(counts.unseen, 4U);
  for (const int stage : {1, 2, 3}) {
    for (const bool unseen : {false, true}) {
      const std::vector<bool> admitted = admittedTriangles(perception, stage, unseen);
      EXPECT_EQ(counts.admitted(stage, unseen), std::count(admitted.begin(), admitted.end(), true));
    }
  }
}

/// Triangles of pixels in bins 5, 15, 25 and 35.
Perception ofPixels(const std::vector<std::array<std::uint32_t, kDetailClasses>>& triangles) {
  Perception perception;
  std::vector<std::uint32_t> bins(triangles.size() * kDifferenceBins, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    perception.pixels.push_back(0);
    for (std::size_t k = 0; k < kDetailClasses; ++k) {
      bins[t * kDifferenceBins + 5 + 10 * k] = triangles[t][k];
      perception.pixels.back() += triangles[t][k];
    }
  }
  perception.triangleBins = std::make_shared<const std::vector<std::uint32_t>>(std::move(bins));
  return perception;
}

TEST(ClassesOfTriangles, AreThoseOfMostPixels) {
  const Perception perception =
      ofPixels({{0, 0, 0, 0}, {0, 0, 0, 1}, {2, 3, 1, 2}, {1, 2, 2, 0}, {2, 1, 1, 2}, {0, 0, 5, 5}});
  DifferenceClasses differences;
  differences.cuts = {10, 20, 30};
  using enum DetailClass;
  EXPECT_EQ(classesOfTriangles(perception, differences),
            (std::vector{None, Dramatic, Slight, Slight, None, Moderate}));
  differences.cuts = {10, 10, 30};  // the pixels of two bins together
  EXPECT_EQ(classesOfTriangles(perception, differences),
            (std::vector{None, Dramatic, Moderate, Moderate, None, Moderate}));
  differences.cuts = {kDifferenceBins, kDifferenceBins, kDifferenceBins};
  EXPECT_EQ(classesOfTriangles(perception, differences), std::vector(6, None));
}

}  // namespace
}  // namespace lodestone
