#include "algorithms/perception/difference_classes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace lodestone {
namespace {

constexpr double kLeastSigma = 0.3;  // grey levels
constexpr int kMostRounds = 500;

/// All differences of a bin count as its middle, grey levels.
double middle(int bin) {
  return (binBegin(bin) + binBegin(bin + 1)) / 2;
}

/// Classes as bins: class k begins at [k] and ends at [k + 1]. None is empty.
using Limits = std::vector<int>;

double pixelsIn(const DifferenceHistogram& histogram, int begin, int end) {
  double pixels = 0;
  for (int bin = begin; bin < end; ++bin)
    pixels += static_cast<double>(histogram[static_cast<std::size_t>(bin)]);
  return pixels;
}

/// The Gaussian of largest likelihood; its prior is the number of pixels, not yet their share.
Gaussian fit(const DifferenceHistogram& histogram, int begin, int end) {
  Gaussian gaussian{pixelsIn(histogram, begin, end), 0, 0};
  if (gaussian.prior == 0) return {};
  double squares = 0;
  for (int bin = begin; bin < end; ++bin)
    gaussian.mean += static_cast<double>(histogram[static_cast<std::size_t>(bin)]) * middle(bin);
  gaussian.mean /= gaussian.prior;
  for (int bin = begin; bin < end; ++bin) {
    const double away = middle(bin) - gaussian.mean;
    squares += static_cast<double>(histogram[static_cast<std::size_t>(bin)]) * away * away;
  }
  gaussian.sigma = std::max(kLeastSigma, std::sqrt(squares / gaussian.prior));
  return gaussian;
}

/// The limits that k-means ends with, the best there are (not only from some start): in one dimension all can
/// be tried. Least sum of squares over the first bins, class by class. \pre as many bins hold pixels
class KMeans {
 public:
  explicit KMeans(const DifferenceHistogram& histogram) {
    for (int bin = 0; bin < kDifferenceBins; ++bin)
      if (histogram[static_cast<std::size_t>(bin)] > 0) bins_.push_back(bin);
    sums_.resize(bins_.size() + 1);
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      const auto pixels = static_cast<double>(histogram[static_cast<std::size_t>(bins_[i])]);
      const double grey = middle(bins_[i]);
      sums_[i + 1] = {sums_[i].pixels + pixels, sums_[i].grey + pixels * grey,
                      sums_[i].squares + pixels * grey * grey};
    }
  }

  [[nodiscard]] Limits run() const {
    const std::size_t classes = std::min(kDetailClasses, bins_.size());
    const std::size_t ends = bins_.size() + 1;
    // By number of classes and end of the last one: where this one begins.
    std::vector<std::vector<std::size_t>> begins(classes, std::vector<std::size_t>(ends, 0));
    std::vector<double> least(ends);
    for (std::size_t end = 0; end < ends; ++end) least[end] = squares(0, end);
    for (std::size_t k = 1; k < classes; ++k) {
      std::vector<double> next(ends, std::numeric_limits<double>::infinity());
      for (std::size_t end = k + 1; end < ends; ++end) {
        for (std::size_t begin = k; begin < end; ++begin) {
          const double sum = least[begin] + squares(begin, end);
          if (sum >= next[end]) continue;
          next[end] = sum;
          begins[k][end] = begin;
        }
      }
      least = std::move(next);
    }
    Limits limits(classes + 1, kDifferenceBins);
    std::size_t end = bins_.size();
    for (std::size_t k = classes; k-- > 0;) {
      end = begins[k][end];
      limits[k] = k > 0 ? bins_[end] : 0;
    }
    return limits;
  }

 private:
  struct Sums {
    double pixels = 0, grey = 0, squares = 0;
  };

  [[nodiscard]] double squares(std::size_t begin, std::size_t end) const {
    const Sums& a = sums_[begin];
    const Sums& b = sums_[end];
    const double grey = b.grey - a.grey;
    return end - begin < 2 ? 0 : b.squares - a.squares - grey * grey / (b.pixels - a.pixels);
  }

  std::vector<int> bins_;   ///< that hold pixels
  std::vector<Sums> sums_;  ///< over the bins before
};

/// ln(prior · density), without what all classes share.
double likelihood(const Gaussian& gaussian, double grey) {
  const double away = (grey - gaussian.mean) / gaussian.sigma;
  return std::log(gaussian.prior / gaussian.sigma) - away * away / 2;
}

/// The first bin that rather belongs to the upper of two neighbours. Between their means, where it is looked
/// for, the ratio of their densities rises: there is one such bin.
int crossing(const Gaussian& lower, const Gaussian& upper) {
  int bin = 0;
  while (middle(bin) < lower.mean) ++bin;
  while (middle(bin) <= upper.mean && likelihood(lower, middle(bin)) >= likelihood(upper, middle(bin))) ++bin;
  return bin;
}

/// One round: fits the classes, and gives each bin to the more likely of those whose means it lies between.
/// That never lowers the likelihood, as a bin is in one of the two already. Classes that lose all their
/// pixels are gone.
Limits refined(const DifferenceHistogram& histogram, const Limits& limits) {
  Limits next{0};
  Gaussian lower = fit(histogram, limits[0], limits[1]);
  for (std::size_t k = 1; k + 1 < limits.size(); ++k) {
    const Gaussian upper = fit(histogram, limits[k], limits[k + 1]);
    const int cut = crossing(lower, upper);
    if (pixelsIn(histogram, next.back(), cut) > 0) next.push_back(cut);
    lower = upper;
  }
  if (pixelsIn(histogram, next.back(), kDifferenceBins) == 0) next.pop_back();
  next.push_back(kDifferenceBins);
  return next;
}

Limits mostLikely(const DifferenceHistogram& histogram) {
  Limits limits = KMeans(histogram).run();
  for (int round = 0; round < kMostRounds; ++round) {
    Limits next = refined(histogram, limits);
    if (next == limits) break;
    limits = std::move(next);
  }
  return limits;
}

/// Cuts that the options name stand: found ones give way, and so does a named one above which a lower class
/// is named.
void takeNamed(DifferenceClasses& classes, const PerceiveOptions& options) {
  const std::array<double, kDetailClasses - 1> named{options.slight, options.moderate, options.dramatic};
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (named[i] <= 0) continue;
    classes.cuts[i] = differenceBin(static_cast<float>(named[i]));
    for (std::size_t below = 0; below < i; ++below)
      if (named[below] <= 0) classes.cuts[below] = std::min(classes.cuts[below], classes.cuts[i]);
  }
  for (std::size_t i = 1; i < named.size(); ++i)
    classes.cuts[i] = std::max(classes.cuts[i], classes.cuts[i - 1]);
}

/// What the classes hold as they are cut.
void describe(DifferenceClasses& classes, const DifferenceHistogram& histogram) {
  const double pixels = pixelsIn(histogram, 0, kDifferenceBins);
  for (std::size_t k = 0; k < kDetailClasses; ++k) {
    const int begin = k == 0 ? 0 : classes.cuts[k - 1];
    const int end = k + 1 == kDetailClasses ? kDifferenceBins : classes.cuts[k];
    classes.gaussians[k] = fit(histogram, begin, end);
    if (pixels > 0) classes.gaussians[k].prior /= pixels;
  }
}

}  // namespace

DifferenceClasses classifyDifferences(const DifferenceHistogram& histogram, const PerceiveOptions& options) {
  DifferenceClasses classes;
  if (pixelsIn(histogram, 0, kDifferenceBins) > 0) {
    const Limits limits = mostLikely(histogram);
    for (std::size_t k = 1; k + 1 < limits.size(); ++k) classes.cuts[k - 1] = limits[k];
  }
  takeNamed(classes, options);
  describe(classes, histogram);
  return classes;
}

}  // namespace lodestone
