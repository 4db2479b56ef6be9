// The light that models are looked at in to judge what people perceive (Du, Zhu and Zhao, Eq. (4)).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/geometry.h"

namespace lodestone {

/// Ambient light and three lamps far away, the same for every model and every picture: I = k_a I_a + k_d Σ
/// f_i I_i max(0, N · L_i) with k_a = k_d = f_i = 1, since what is far away does not attenuate. Above 0 for
/// any normal, and at most 1.
struct FixedLights {
  double ambient = 0.25;
  std::array<double, 3> intensities{0.5, 0.35, 0.3};
  /// Unit, towards the lamps: a key from the south-west, a fill from the east, a third from the north-west,
  /// all from above, so that walls of any direction differ and undersides are dark.
  std::array<Vec3, 3> directions{towards(225, 40), towards(80, 30), towards(335, 20)};

  /// Of a surface with a unit normal; what has none (zero) is in ambient light alone.
  [[nodiscard]] double brightness(const Vec3& normal) const {
    double sum = ambient;
    for (std::size_t i = 0; i < directions.size(); ++i)
      sum += intensities[i] * std::max(0.0, normal.dot(directions[i]));
    return sum;
  }

  /// Azimuth from north, clockwise, and elevation, degrees.
  [[nodiscard]] static Vec3 towards(double azimuth, double elevation) {
    constexpr double kRadians = std::numbers::pi / 180;
    const double flat = std::cos(elevation * kRadians);
    return {flat * std::sin(azimuth * kRadians), flat * std::cos(azimuth * kRadians),
            std::sin(elevation * kRadians)};
  }
};

}  // namespace lodestone
