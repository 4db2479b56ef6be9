// The light that models are looked at in to judge what people perceive (Du, Zhu and Zhao, Eq. (4)).
#pragma once

#include <algorithm>
#include <array>

#include "model/geometry.h"

namespace lodestone {

/// Ambient light and three lamps far away, the same for every model and every picture: I = k_a I_a + k_d Σ
/// f_i I_i max(0, N · L_i) with k_a = k_d = f_i = 1, since what is far away does not attenuate. Above 0 for
/// any normal, and at most 1.
struct FixedLights {
  double ambient = 0.25;
  std::array<double, 3> intensities{0.55, 0.25, 0.15};
  /// Unit, towards the lamps: a key from the south-west, a fill from the east, one from the north and below,
  /// so that no face that can be seen is only in ambient light.
  std::array<Vec3, 3> directions{Vec3(-0.5, -0.6, 0.65).normalized(), Vec3(0.85, 0.1, 0.45).normalized(),
                                 Vec3(-0.2, 0.8, -0.45).normalized()};

  /// Of a surface with a unit normal; what has none (zero) is in ambient light alone.
  [[nodiscard]] double brightness(const Vec3& normal) const {
    double sum = ambient;
    for (std::size_t i = 0; i < directions.size(); ++i)
      sum += intensities[i] * std::max(0.0, normal.dot(directions[i]));
    return sum;
  }
};

}  // namespace lodestone
