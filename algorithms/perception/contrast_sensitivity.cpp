#include "algorithms/perception/contrast_sensitivity.h"

#include <cmath>
#include <numbers>

namespace lodestone {
namespace {

// Du, Zhu and Zhao, eq. 1.
constexpr double kGain = 2.6;
constexpr double kOffset = 0.0192;
constexpr double kPower = 1.1;

/// c times the frequency at the peak. There 1 = 1.1 (0.0192 + u) u^0.1 (the derivative of A is 0); the right
/// side rises with u, from 0 to above 1 at 1.
double findPeak() {
  double low = 0;
  double high = 1;
  for (double u = 0.5; low < u && u < high; u = (low + high) / 2)
    (kPower * (kOffset + u) * std::pow(u, kPower - 1) < 1 ? low : high) = u;
  return high;
}

}  // namespace

double contrastSensitivity(double frequency, double c) {
  const double u = c * frequency;
  return kGain * (kOffset + u) * std::exp(-std::pow(u, kPower));
}

double peakFrequency(double c) {
  static const double peak = findPeak();
  return peak / c;
}

double bandFrequency(int level, bool diagonal, double pixelsPerDegree) {
  return std::ldexp(0.75 * pixelsPerDegree, -level) * (diagonal ? std::numbers::sqrt2 : 1);
}

double bandWeight(int level, bool diagonal, double pixelsPerDegree, double c) {
  const double frequency = bandFrequency(level, diagonal, pixelsPerDegree);
  const double peak = peakFrequency(c);
  return frequency <= peak ? 1 : contrastSensitivity(frequency, c) / contrastSensitivity(peak, c);
}

}  // namespace lodestone
