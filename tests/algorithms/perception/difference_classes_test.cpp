#include "algorithms/perception/difference_classes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/plain_classes.h"

namespace lodestone {
namespace {

using Histogram = DifferenceHistogram;

std::uint64_t& at(Histogram& histogram, int bin) {
  return histogram[static_cast<std::size_t>(bin)];
}

std::uint64_t total(const Histogram& histogram) {
  return std::accumulate(histogram.begin(), histogram.end(), std::uint64_t{0});
}

struct Part {
  int samples;
  double mean;
  double sigma;
};

Histogram drawn(const std::vector<Part>& parts, std::mt19937& random) {
  Histogram histogram{};
  for (const Part& part : parts) {
    std::normal_distribution<double> grey(part.mean, part.sigma);
    for (int i = 0; i < part.samples; ++i)
      ++at(histogram, differenceBin(static_cast<float>(std::abs(grey(random)))));
  }
  return histogram;
}

/// As different ones as there are: few bins or many, even or heaped.
Histogram randomHistogram(std::mt19937& random) {
  std::uniform_int_distribution<int> number(0, 2);
  if (number(random) == 0) {
    std::uniform_real_distribution<double> mean(0, 200);
    std::uniform_real_distribution<double> sigma(0.1, 30);
    return drawn({{20'000, 0, sigma(random) / 10},
                  {4'000, mean(random), sigma(random)},
                  {2'000, mean(random), sigma(random)},
                  {500, mean(random), sigma(random)}},
                 random);
  }
  Histogram histogram{};
  const int bins = std::uniform_int_distribution(1, number(random) == 0 ? 6 : 200)(random);
  for (int i = 0; i < bins; ++i)
    at(histogram, std::uniform_int_distribution(0, kDifferenceBins - 1)(random)) +=
        static_cast<std::uint64_t>(std::exp(std::uniform_real_distribution<double>(0, 15)(random)));
  return histogram;
}

TEST(DifferenceClasses, FindsTheGaussiansThatWereDrawnFrom) {
  std::mt19937 random(1);
  const std::vector<Part> parts{{60'000, 2, 0.4}, {20'000, 12, 2}, {15'000, 50, 6}, {5'000, 140, 15}};
  const Histogram histogram = drawn(parts, random);
  const DifferenceClasses classes = classifyDifferences(histogram, {});
  for (std::size_t k = 0; k < kDetailClasses; ++k) {
    EXPECT_NEAR(classes.gaussians[k].prior, parts[k].samples / 1e5, 0.002) << k;
    EXPECT_NEAR(classes.gaussians[k].mean, parts[k].mean, 0.02 * parts[k].mean) << k;
    EXPECT_NEAR(classes.gaussians[k].sigma, parts[k].sigma, 0.05 * parts[k].sigma) << k;
  }
  // All are so far apart that each difference belongs to the likeliest of all four.
  for (int bin = 0; bin < kDifferenceBins; ++bin) {
    const auto best = std::max_element(
        classes.gaussians.begin(), classes.gaussians.end(), [&](const Gaussian& a, const Gaussian& b) {
          return classScore(a, middleOfBin(bin)) < classScore(b, middleOfBin(bin));
        });
    EXPECT_EQ(static_cast<long>(classes.of(bin)), best - classes.gaussians.begin()) << bin;
  }
}

TEST(DifferenceClasses, EqualsTheProcedureOverSingleDifferences) {
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i) {
    Histogram histogram{};
    const int bins = std::uniform_int_distribution(1, 14)(random);
    const int highest = std::uniform_int_distribution(10, kDifferenceBins - 1)(random);
    for (int k = 0; k < bins; ++k)
      at(histogram, std::uniform_int_distribution(0, highest)(random)) +=
          static_cast<std::uint64_t>(std::uniform_int_distribution(1, k % 3 == 0 ? 200 : 9)(random));
    const DifferenceClasses classes = classifyDifferences(histogram, {});
    const std::vector<std::size_t> sizes = PlainClasses(histogram).run();
    for (std::size_t k = 0; k < kDetailClasses; ++k)
      EXPECT_NEAR(classes.gaussians[k].prior * static_cast<double>(total(histogram)),
                  static_cast<double>(sizes[k]), 1e-6)
          << "histogram " << i << ", class " << k;
  }
}

void expectOrder(const DifferenceClasses& classes) {
  EXPECT_TRUE(std::is_sorted(classes.cuts.begin(), classes.cuts.end()));
  EXPECT_GE(classes.cuts.front(), 0);
  EXPECT_LE(classes.cuts.back(), kDifferenceBins);
  double mean = -1;
  for (const Gaussian& gaussian : classes.gaussians) {
    if (gaussian.prior == 0) continue;
    EXPECT_GT(gaussian.mean, mean);
    EXPECT_GE(gaussian.sigma, 0.3);
    mean = gaussian.mean;
  }
}

/// Neighbours are cut at the first bin between their means that the upper one is likelier to have made.
void expectCrossing(const Gaussian& lower, const Gaussian& upper, int cut) {
  const auto isUpper = [&](int bin) {
    return classScore(upper, middleOfBin(bin)) > classScore(lower, middleOfBin(bin));
  };
  EXPECT_GE(middleOfBin(cut), lower.mean);
  EXPECT_LE(middleOfBin(cut - 1), upper.mean);
  EXPECT_TRUE(middleOfBin(cut) > upper.mean || isUpper(cut));
  EXPECT_TRUE(middleOfBin(cut - 1) < lower.mean || !isUpper(cut - 1));
}

TEST(DifferenceClasses, AreCutWhereTheirGaussiansCross) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    const Histogram histogram = randomHistogram(random);
    const DifferenceClasses classes = classifyDifferences(histogram, {});
    expectOrder(classes);
    double share = 0;
    for (const Gaussian& gaussian : classes.gaussians) share += gaussian.prior;
    EXPECT_NEAR(share, 1, 1e-9);
    for (std::size_t k = 0; k + 1 < kDetailClasses; ++k) {
      if (classes.gaussians[k + 1].prior == 0) {
        EXPECT_EQ(classes.cuts[k], kDifferenceBins);
      } else {
        expectCrossing(classes.gaussians[k], classes.gaussians[k + 1], classes.cuts[k]);
      }
    }
  }
}

TEST(DifferenceClasses, DoNotDependOnTheNumberOfPixels) {
  std::mt19937 random(4);
  for (int i = 0; i < 50; ++i) {
    Histogram histogram = randomHistogram(random);
    const DifferenceClasses once = classifyDifferences(histogram, {});
    for (std::uint64_t& pixels : histogram) pixels *= 1024;
    EXPECT_EQ(classifyDifferences(histogram, {}).cuts, once.cuts);
  }
}

void expectAllNone(const DifferenceClasses& classes) {
  EXPECT_EQ(classes.cuts, DifferenceClasses{}.cuts);
  for (int bin = 0; bin < kDifferenceBins; ++bin) EXPECT_EQ(classes.of(bin), DetailClass::None);
  EXPECT_EQ(classes.gaussians[1].prior, 0);
  EXPECT_EQ(classes.gaussians[2].prior, 0);
  EXPECT_EQ(classes.gaussians[3].prior, 0);
}

TEST(DifferenceClasses, NothingIsInNoClass) {
  const DifferenceClasses classes = classifyDifferences({}, {});
  expectAllNone(classes);
  EXPECT_EQ(classes.gaussians[0].prior, 0);
}

TEST(DifferenceClasses, OneColourIsOneClass) {
  Histogram histogram{};
  at(histogram, 0) = 1'000'000;
  const DifferenceClasses classes = classifyDifferences(histogram, {});
  expectAllNone(classes);
  EXPECT_EQ(classes.gaussians[0].prior, 1);
  EXPECT_EQ(classes.gaussians[0].sigma, 0.3);
}

TEST(DifferenceClasses, OneBinAnywhereIsOneClass) {
  for (int bin = 0; bin < kDifferenceBins; ++bin) {
    Histogram histogram{};
    at(histogram, bin) = 3;
    expectAllNone(classifyDifferences(histogram, {}));
  }
}

TEST(DifferenceClasses, FewAmongManyThatAreAlikeAreNoClass) {
  Histogram histogram{};
  at(histogram, 0) = 1'000'000;
  for (int bin = 1; bin < 4; ++bin) at(histogram, bin) = 10;  // up to 1/16 of a grey level
  expectAllNone(classifyDifferences(histogram, {}));
}

TEST(DifferenceClasses, FewDifferencesFillTheLowerClasses) {
  Histogram histogram{};
  at(histogram, 0) = 1'000'000'000'000;
  at(histogram, 160) = 700'000'000'000;
  DifferenceClasses classes = classifyDifferences(histogram, {});
  EXPECT_EQ(classes.of(0), DetailClass::None);
  EXPECT_EQ(classes.of(160), DetailClass::Slight);
  EXPECT_EQ(classes.cuts[1], kDifferenceBins);
  EXPECT_NEAR(middleOfBin(classes.cuts[0]), middleOfBin(160) / 2, 1);
  at(histogram, 80) = 5;
  at(histogram, 255) = 5;
  classes = classifyDifferences(histogram, {});
  EXPECT_EQ(classes.of(0), DetailClass::None);
  EXPECT_EQ(classes.of(80), DetailClass::Slight);
  EXPECT_EQ(classes.of(160), DetailClass::Moderate);
  EXPECT_EQ(classes.of(255), DetailClass::Dramatic);
}

TEST(DifferenceClasses, NamedThresholdsStand) {
  std::mt19937 random(5);
  const double greys[] = {0, 0.001, 0.5, 4, 30, 100, 255};
  std::uniform_int_distribution<std::size_t> any(0, std::size(greys) - 1);
  for (int i = 0; i < 300; ++i) {
    const Histogram histogram = i % 10 == 0 ? Histogram{} : randomHistogram(random);
    PerceiveOptions options;
    options.slight = greys[any(random)];
    options.moderate = greys[any(random)];
    options.dramatic = greys[any(random)];
    const DifferenceClasses classes = classifyDifferences(histogram, options);
    expectOrder(classes);
    const double named[] = {options.slight, options.moderate, options.dramatic};
    double above = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (named[k] == 0) continue;
      above = std::max(above, named[k]);
      EXPECT_EQ(classes.cuts[k], differenceBin(static_cast<float>(above)));
    }
    for (std::size_t k = 0; k < kDetailClasses; ++k) {
      std::uint64_t pixels = 0;
      for (int bin = 0; bin < kDifferenceBins; ++bin)
        if (static_cast<std::size_t>(classes.of(bin)) == k)
          pixels += histogram[static_cast<std::size_t>(bin)];
      EXPECT_NEAR(classes.gaussians[k].prior * static_cast<double>(total(histogram)),
                  static_cast<double>(pixels), 1e-9 * static_cast<double>(total(histogram)));
    }
  }
}

TEST(DifferenceClasses, AllNamedLeaveNothingToBeFound) {
  PerceiveOptions options;
  options.slight = 1;
  options.moderate = 4;
  options.dramatic = 16;
  const DifferenceClasses classes = classifyDifferences({}, options);
  EXPECT_EQ(classes.cuts, (std::array{16, 32, 64}));
}

}  // namespace
}  // namespace lodestone
