#include "algorithms/perception/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "algorithms/geometry/vector_clones.h"

namespace lodestone {
namespace {

constexpr double kPi = std::numbers::pi;

/// A term a √(π/b) exp(−π² x² / b) of a contrast sensitivity function, x in degrees (equation 1, table 1).
struct Sensitivity {
  double a;
  double b;
};
constexpr Sensitivity kLightness{1, 0.0047};
constexpr Sensitivity kRedGreen{1, 0.0053};
constexpr std::array<Sensitivity, 2> kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};
/// Width of the features that are looked for, degrees (section 4.2.1).
constexpr double kFeatureWidth = 0.082;
/// Taps are left out from where all the rest of them weigh less than what floats can tell.
constexpr double kNegligible = 1e-9;

using Taps = std::vector<double>;  // of one half, from the middle outwards

Taps tapsOf(std::size_t radius, const std::function<double(double)>& weight) {
  Taps taps(radius + 1);
  for (std::size_t k = 0; k <= radius; ++k) taps[k] = weight(static_cast<double>(k));
  return taps;
}

/// Of both halves. The small ones first.
double sumOf(const Taps& taps) {
  return 2 * std::accumulate(taps.rbegin(), taps.rend() - 1, 0.0) + taps.front();
}

void scale(Taps& taps, double factor) {
  for (double& tap : taps) tap *= factor;
}

/// A tap `length` − 1 or more from the middle meets what lies beyond an end, or the end itself.
HalfFilter folded(const Taps& taps, std::size_t length, bool odd = false) {
  double magnitude = 0;
  for (const double tap : taps) magnitude += std::abs(tap);
  HalfFilter filter{{}, odd};
  std::size_t kept = taps.size();
  for (double rest = 0; kept > 1; --kept) {
    rest += std::abs(taps[kept - 1]);
    if (rest > kNegligible * magnitude) break;
  }
  const std::size_t reach = std::min(kept, std::max<std::size_t>(length, 1)) - 1;
  for (std::size_t k = 0; k < reach; ++k) filter.taps.push_back(static_cast<float>(taps[k]));
  double last = std::accumulate(taps.rbegin(), taps.rend() - static_cast<std::ptrdiff_t>(reach), 0.0);
  if (reach == 0) last = odd ? 0 : sumOf(taps);  // the middle meets them all
  filter.taps.push_back(static_cast<float>(last));
  return filter;
}

/// One factor of the two-dimensional term, of sum 1.
Taps sensitivityTaps(const Sensitivity& term, std::size_t radius, double pixelsPerDegree) {
  const double spread = kPi * kPi / (term.b * pixelsPerDegree * pixelsPerDegree);
  Taps taps = tapsOf(radius, [&](double k) { return std::exp(-spread * k * k); });
  scale(taps, 1 / sumOf(taps));
  return taps;
}

/// What a term weighs over the whole plane of taps.
double weightOf(const Sensitivity& term, std::size_t radius, double pixelsPerDegree) {
  const double spread = kPi * kPi / (term.b * pixelsPerDegree * pixelsPerDegree);
  const double sum = sumOf(tapsOf(radius, [&](double k) { return std::exp(-spread * k * k); }));
  return term.a * std::sqrt(kPi / term.b) * sum * sum;
}

void addSensitivities(double pixelsPerDegree, std::size_t length, FlipFilters& filters) {
  // Three standard deviations of the widest term, for all of them.
  const auto radius = static_cast<std::size_t>(
      std::ceil(3 * std::sqrt(kBlueYellow[0].b / (2 * kPi * kPi)) * pixelsPerDegree));
  filters.lightness = folded(sensitivityTaps(kLightness, radius, pixelsPerDegree), length);
  filters.redGreen = folded(sensitivityTaps(kRedGreen, radius, pixelsPerDegree), length);
  std::array<double, 2> weights{};
  for (std::size_t i = 0; i < 2; ++i) weights[i] = weightOf(kBlueYellow[i], radius, pixelsPerDegree);
  for (std::size_t i = 0; i < 2; ++i) {
    Taps taps = sensitivityTaps(kBlueYellow[i], radius, pixelsPerDegree);
    scale(taps, std::sqrt(weights[i] / (weights[0] + weights[1])));  // once along rows, once along columns
    filters.blueYellow[i] = folded(taps, length);
  }
}

/// Positive weights of sum 1 and negative ones of sum −1, over both halves.
void balance(Taps& taps) {
  Taps positive = taps;
  Taps negative = taps;
  for (double& tap : positive) tap = std::max(tap, 0.0);
  for (double& tap : negative) tap = std::max(-tap, 0.0);
  const double up = sumOf(positive);
  const double down = sumOf(negative);
  for (double& tap : taps) tap /= tap > 0 ? up : down > 0 ? down : 1;
}

void addFeatures(double pixelsPerDegree, std::size_t length, FlipFilters& filters) {
  const double sigma = 0.5 * kFeatureWidth * pixelsPerDegree;
  const auto radius = static_cast<std::size_t>(std::ceil(3 * sigma));
  const auto bell = [&](double k) { return std::exp(-k * k / (2 * sigma * sigma)); };
  Taps gaussian = tapsOf(radius, bell);
  scale(gaussian, 1 / sumOf(gaussian));
  // The first derivative falls on one side and rises on the other, by 1 each; its sign does not matter.
  Taps edge = tapsOf(radius, [&](double k) { return k * bell(k); });
  scale(edge, 2 / sumOf(edge));
  Taps point = tapsOf(radius, [&](double k) { return (k * k / (sigma * sigma) - 1) * bell(k); });
  balance(point);
  filters.gaussian = folded(gaussian, length);
  filters.edge = folded(edge, length, true);
  filters.point = folded(point, length);
}

LODESTONE_VECTOR_CLONES
void setScaled(const float* a, float tap, std::size_t count, float* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = tap * a[i];
}

LODESTONE_VECTOR_CLONES
void addScaled(const float* a, float tap, std::size_t count, float* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] += tap * a[i];
}

LODESTONE_VECTOR_CLONES
void addSums(const float* a, const float* b, float tap, std::size_t count, float* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] += tap * (a[i] + b[i]);
}

LODESTONE_VECTOR_CLONES
void addDifferences(const float* a, const float* b, float tap, std::size_t count, float* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] += tap * (a[i] - b[i]);
}

void addSides(const HalfFilter& filter, TapRows rows, std::size_t count, float* out) {
  const auto add = filter.odd ? addDifferences : addSums;
  for (std::size_t k = 1; k < filter.taps.size(); ++k) {
    const auto step = static_cast<std::ptrdiff_t>(k);
    add(rows[step], rows[-step], filter.taps[k], count, out);
  }
}

}  // namespace

std::size_t FlipFilters::reach() const {
  std::size_t taps = 1;
  for (const HalfFilter* filter :
       {&lightness, &redGreen, blueYellow.data(), &blueYellow[1], &gaussian, &edge, &point})
    taps = std::max(taps, filter->taps.size());
  return taps - 1;
}

FlipFilters flipFilters(double pixelsPerDegree, std::size_t length) {
  FlipFilters filters;
  addSensitivities(pixelsPerDegree, length, filters);
  addFeatures(pixelsPerDegree, length, filters);
  return filters;
}

void applyFilter(const HalfFilter& filter, TapRows rows, std::size_t count, float* out) {
  setScaled(rows[0], filter.taps[0], count, out);
  addSides(filter, rows, count, out);
}

void addFilter(const HalfFilter& filter, TapRows rows, std::size_t count, float* out) {
  addScaled(rows[0], filter.taps[0], count, out);
  addSides(filter, rows, count, out);
}

}  // namespace lodestone
