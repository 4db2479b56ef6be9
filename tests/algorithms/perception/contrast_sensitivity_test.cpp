#include "algorithms/perception/contrast_sensitivity.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace lodestone {
namespace {

constexpr double kMannos = 0.114;
constexpr double kDu = 0.144;

TEST(ContrastSensitivity, EqualsTheFormula) {
  EXPECT_DOUBLE_EQ(contrastSensitivity(0, kMannos), 2.6 * 0.0192);
  EXPECT_NEAR(contrastSensitivity(1 / kDu, kDu), 2.6 * 1.0192 / std::numbers::e, 1e-12);
}

TEST(ContrastSensitivity, PeakIsLargest) {
  for (const double c : {0.02, kMannos, kDu, 1.0}) {
    const double peak = peakFrequency(c);
    const double largest = contrastSensitivity(peak, c);
    double best = 0;
    for (int i = 1; i <= 20'000; ++i) {
      const double frequency = 4 * peak * i / 20'000;
      EXPECT_LE(contrastSensitivity(frequency, c), largest + 1e-14);
      if (contrastSensitivity(frequency, c) > contrastSensitivity(best, c)) best = frequency;
    }
    EXPECT_NEAR(best, peak, 1e-3 * peak);
  }
  // Mannos and Sakrison put a peak of about 1 at about 8 cycles per degree.
  EXPECT_NEAR(peakFrequency(kMannos), 8, 0.2);
  EXPECT_NEAR(contrastSensitivity(peakFrequency(kMannos), kMannos), 1, 0.03);
}

TEST(ContrastSensitivity, BandsHalveInFrequency) {
  EXPECT_DOUBLE_EQ(bandFrequency(1, false, 40), 15);
  EXPECT_DOUBLE_EQ(bandFrequency(2, false, 40), 7.5);
  EXPECT_DOUBLE_EQ(bandFrequency(5, false, 40), 0.9375);
  EXPECT_DOUBLE_EQ(bandFrequency(1, true, 40), 15 * std::numbers::sqrt2);
}

TEST(ContrastSensitivity, WeightsFallWithFrequencyFromOne) {
  for (const double c : {kMannos, kDu}) {
    for (const double pixelsPerDegree : {2.0, 20.0, 38.0, 100.0, 1000.0}) {
      for (const bool diagonal : {false, true}) {
        for (int level = 1; level <= 5; ++level) {
          const double weight = bandWeight(level, diagonal, pixelsPerDegree, c);
          const bool keeps = bandFrequency(level, diagonal, pixelsPerDegree) <= peakFrequency(c);
          EXPECT_GT(weight, 0);
          EXPECT_EQ(weight == 1, keeps);
          EXPECT_LE(weight, bandWeight(level + 1, diagonal, pixelsPerDegree, c));
          EXPECT_LE(bandWeight(level, true, pixelsPerDegree, c), weight);
        }
      }
    }
  }
  // By hand: 15 cycles per degree are u = 1.71, and A = 2.6 · 1.7292 · exp(−1.71^1.1) = 0.7400 of 0.9809.
  EXPECT_NEAR(bandWeight(1, false, 40, kMannos), 0.7400 / 0.9809, 1e-4);
}

}  // namespace
}  // namespace lodestone
