// LDR-ꟻLIP as the paper writes it down: every filter two-dimensional, every number a double, pixel by pixel.
// Slow and obvious; what the fast one is held against.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "algorithms/rendering/rendering.h"

namespace lodestone::test {

using Triple = std::array<double, 3>;

class PlainFlip {
 public:
  PlainFlip(const Picture& reference, const Picture& test, double pixelsPerDegree)
      : a_(reference), b_(test), ppd_(pixelsPerDegree) {}

  [[nodiscard]] double error(int x, int y) const {
    const double largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), 0.7);
    const double d = std::pow(hyab(huntLab(seen(a_, x, y)), huntLab(seen(b_, x, y))), 0.7);
    const double knee = 0.4 * largest;
    const double colour = d < knee ? d * 0.95 / knee : 0.95 + (d - knee) / (largest - knee) * 0.05;
    const double edges = std::abs(feature(a_, x, y, false) - feature(b_, x, y, false));
    const double points = std::abs(feature(a_, x, y, true) - feature(b_, x, y, true));
    return std::pow(colour, 1 - std::pow(std::max(edges, points) / std::sqrt(2.0), 0.5));
  }

 private:
  using Weight = std::function<double(double x, double y)>;
  static constexpr double kPi = std::numbers::pi;

  static Triple linearPixel(const Picture& p, int x, int y) {
    x = std::clamp(x, 0, p.width - 1);
    y = std::clamp(y, 0, p.height - 1);
    Triple rgb{};
    for (std::size_t c = 0; c < 3; ++c) {
      const double v = p.rgba[4 * static_cast<std::size_t>(y * p.width + x) + c] / 255.0;
      rgb[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    return rgb;
  }

  /// XYZ over that of white; the matrix as it is printed for sRGB.
  static Triple xyz(const Triple& rgb) {
    constexpr std::array<Triple, 3> kRows{{{0.4124564, 0.3575761, 0.1804375},
                                           {0.2126729, 0.7151522, 0.0721750},
                                           {0.0193339, 0.1191920, 0.9503041}}};
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Triple& row = kRows[i];
      result[i] = (row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2]) / (row[0] + row[1] + row[2]);
    }
    return result;
  }

  static Triple ycxcz(const Triple& rgb) {
    const Triple v = xyz(rgb);
    return {116 * v[1] - 16, 500 * (v[0] - v[1]), 200 * (v[1] - v[2])};
  }

  /// The nearest colour that a display shows.
  static Triple displayed(const Triple& opponent) {
    const double y = (opponent[0] + 16) / 116;
    const Triple wanted{y + opponent[1] / 500, y, y - opponent[2] / 200};
    std::array<Triple, 3> columns{};
    for (std::size_t c = 0; c < 3; ++c) {
      Triple unit{};
      unit[c] = 1;
      columns[c] = xyz(unit);
    }
    const auto det = [](const Triple& p, const Triple& q, const Triple& r) {
      return p[0] * (q[1] * r[2] - q[2] * r[1]) - q[0] * (p[1] * r[2] - p[2] * r[1]) +
             r[0] * (p[1] * q[2] - p[2] * q[1]);
    };
    const double whole = det(columns[0], columns[1], columns[2]);  // Cramer's rule
    Triple rgb{det(wanted, columns[1], columns[2]) / whole, det(columns[0], wanted, columns[2]) / whole,
               det(columns[0], columns[1], wanted) / whole};
    for (double& c : rgb) c = std::clamp(c, 0.0, 1.0);
    return rgb;
  }

  static Triple huntLab(const Triple& rgb) {
    const auto curve = [](double t) {
      return t > std::pow(6.0 / 29, 3) ? std::cbrt(t) : t / (3 * std::pow(6.0 / 29, 2)) + 4.0 / 29;
    };
    const Triple v = xyz(rgb);
    const double l = 116 * curve(v[1]) - 16;
    return {l, 0.01 * l * 500 * (curve(v[0]) - curve(v[1])), 0.01 * l * 200 * (curve(v[1]) - curve(v[2]))};
  }

  static double hyab(const Triple& p, const Triple& q) {
    return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
  }

  /// A pixel after the contrast sensitivity of each of the three channels.
  [[nodiscard]] Triple seen(const Picture& p, int x, int y) const {
    struct Term {
      double a1, b1, a2, b2;
    };
    constexpr std::array<Term, 3> kTerms{
        {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd_));
    Triple sum{};
    Triple total{};
    for (int dy = -radius; dy <= radius; ++dy) {
      for (int dx = -radius; dx <= radius; ++dx) {
        const Triple pixel = ycxcz(linearPixel(p, x + dx, y + dy));
        const double d2 = (dx * dx + dy * dy) / (ppd_ * ppd_);
        for (std::size_t c = 0; c < 3; ++c) {
          const auto& [a1, b1, a2, b2] = kTerms[c];
          const double w = a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * d2 / b1) +
                           a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * d2 / b2);
          sum[c] += w * pixel[c];
          total[c] += w;
        }
      }
    }
    for (std::size_t c = 0; c < 3; ++c) sum[c] /= total[c];
    return displayed(sum);
  }

  /// How strong an edge or a point is: the length of what its two filters give.
  [[nodiscard]] double feature(const Picture& p, int x, int y, bool points) const {
    const double sigma = 0.5 * 0.082 * ppd_;
    const auto weight = [&](double u, double v) {
      const double bell = std::exp(-(u * u + v * v) / (2 * sigma * sigma));
      return points ? (u * u / (sigma * sigma) - 1) * bell : -u * bell;
    };
    const double across = filtered(p, x, y, weight);
    const double down = filtered(p, x, y, [&](double u, double v) { return weight(v, u); });
    return std::hypot(across, down);
  }

  [[nodiscard]] double filtered(const Picture& p, int x, int y, const Weight& weight) const {
    const int radius = static_cast<int>(std::ceil(3 * 0.5 * 0.082 * ppd_));
    double up = 0;
    double down = 0;
    double above = 0;
    double below = 0;
    for (int dy = -radius; dy <= radius; ++dy) {
      for (int dx = -radius; dx <= radius; ++dx) {
        const double w = weight(dx, dy);
        const double light = (ycxcz(linearPixel(p, x + dx, y + dy))[0] + 16) / 116;
        (w > 0 ? up : down) += std::abs(w);
        (w > 0 ? above : below) += std::abs(w) * light;
      }
    }
    return above / up - below / down;
  }

  const Picture& a_;
  const Picture& b_;
  double ppd_;
};

}  // namespace lodestone::test
