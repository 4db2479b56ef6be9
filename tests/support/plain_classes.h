// The classes of differences found the slow way: every start is tried, every single difference is put into a
// class by itself.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "model/perception.h"

namespace lodestone {

inline double middleOfBin(int bin) {
  return (binBegin(bin) + binBegin(bin + 1)) / 2;
}

/// ln(prior · density), without what all classes share.
inline double classScore(const Gaussian& gaussian, double grey) {
  if (gaussian.prior == 0) return -std::numeric_limits<double>::infinity();
  return std::log(gaussian.prior / gaussian.sigma) - std::pow((grey - gaussian.mean) / gaussian.sigma, 2) / 2;
}

class PlainClasses {
 public:
  /// \pre not empty
  explicit PlainClasses(const DifferenceHistogram& histogram) {
    for (int bin = 0; bin < kDifferenceBins; ++bin) {
      const std::uint64_t pixels = histogram[static_cast<std::size_t>(bin)];
      if (pixels > 0) values_.emplace_back(pixels, middleOfBin(bin));
    }
  }

  /// How many differences each class has.
  std::vector<std::size_t> run() {
    startFromKMeans();
    for (int round = 0; round < 500 && refine(); ++round) {
    }
    std::vector<std::size_t> sizes;
    for (const Group& group : groups_) sizes.push_back(group.size());
    sizes.resize(kDetailClasses, 0);
    return sizes;
  }

 private:
  using Group = std::vector<double>;

  static double mean(const Group& group) {
    return std::accumulate(group.begin(), group.end(), 0.0) / static_cast<double>(group.size());
  }

  static double squares(const Group& group) {
    const double middle = mean(group);
    double sum = 0;
    for (const double grey : group) sum += (grey - middle) * (grey - middle);
    return sum;
  }

  [[nodiscard]] Group group(std::size_t begin, std::size_t end) const {
    Group all;
    for (std::size_t i = begin; i < end; ++i) all.insert(all.end(), values_[i].begin(), values_[i].end());
    return all;
  }

  /// All ways to divide the different values into so many runs, the best one.
  void startFromKMeans() {
    const std::size_t count = values_.size();
    squares_.assign(count, std::vector<double>(count + 1, 0));
    for (std::size_t begin = 0; begin < count; ++begin)
      for (std::size_t end = begin + 1; end <= count; ++end)
        squares_[begin][end] = squares(group(begin, end));
    std::vector<std::size_t> begins{0};
    divide(begins, 0);
    best_.push_back(count);
    for (std::size_t k = 0; k + 1 < best_.size(); ++k) groups_.push_back(group(best_[k], best_[k + 1]));
  }

  void divide(std::vector<std::size_t>& begins, double sum) {
    if (begins.size() == std::min(kDetailClasses, values_.size())) {
      sum += squares_[begins.back()][values_.size()];
      if (sum >= least_) return;
      least_ = sum;
      best_ = begins;
      return;
    }
    const std::size_t last = begins.back();
    for (std::size_t next = last + 1; next < values_.size(); ++next) {
      begins.push_back(next);
      divide(begins, sum + squares_[last][next]);
      begins.pop_back();
    }
  }

  bool refine() {
    std::vector<Gaussian> gaussians;
    for (const Group& group : groups_)
      gaussians.push_back({static_cast<double>(group.size()), mean(group),
                           std::max(0.3, std::sqrt(squares(group) / static_cast<double>(group.size())))});
    std::vector<Group> next(groups_.size());
    for (const Group& group : groups_)
      for (const double grey : group) next[likeliest(gaussians, grey)].push_back(grey);
    std::erase_if(next, [](const Group& group) { return group.empty(); });
    for (Group& group : next) std::sort(group.begin(), group.end());
    const bool changed = next != groups_;
    groups_ = next;
    return changed;
  }

  /// Of the two whose means it lies between.
  static std::size_t likeliest(const std::vector<Gaussian>& gaussians, double grey) {
    std::size_t k = 0;  // the last one whose mean is not above
    while (k + 1 < gaussians.size() && gaussians[k + 1].mean <= grey) ++k;
    const double own = classScore(gaussians[k], grey);
    if (grey < gaussians[k].mean) return k;
    if (k + 1 < gaussians.size() && classScore(gaussians[k + 1], grey) > own) return k + 1;
    if (k > 0 && grey == gaussians[k].mean && classScore(gaussians[k - 1], grey) >= own) return k - 1;
    return k;
  }

  std::vector<Group> values_;  ///< all differences of one value together
  std::vector<std::vector<double>> squares_;
  std::vector<std::size_t> best_;
  double least_ = std::numeric_limits<double>::infinity();
  std::vector<Group> groups_;
};

}  // namespace lodestone
