// The curve of sRGB for whole pictures: many times faster than its powers, and as exact as a picture needs.
#pragma once

#include <algorithm>
#include <array>

#include "model/geometry.h"
#include "model/level_colours.h"

namespace lodestone {

/// toSrgb() by a table of its values; within 0.0002 of it, and the same wherever it is asked. Beyond 0–1 it
/// is held at its ends.
[[nodiscard]] inline float encodeSrgb(float linear) {
  constexpr std::size_t kSteps = 4096;
  static const auto table = [] {
    std::array<float, kSteps + 2> values{};
    for (std::size_t i = 0; i <= kSteps; ++i) values[i] = toSrgb(static_cast<float>(i) / kSteps);
    values[kSteps + 1] = values[kSteps];
    return values;
  }();
  const float place = (linear > 0 ? std::min(linear, 1.F) : 0.F) * kSteps;  // 0 of what is no number
  const auto below = static_cast<std::size_t>(place);
  return table[below] + (table[below + 1] - table[below]) * (place - static_cast<float>(below));
}

/// toLinear() of an 8-bit value.
[[nodiscard]] inline float decodeSrgb(std::uint8_t value) {
  static const auto table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = toLinear(static_cast<float>(i) / 255);
    return values;
  }();
  return table[value];
}

/// Of linear sRGB (Rec. 709).
[[nodiscard]] inline float luminance(const Vec3f& linear) {
  return 0.2126F * linear.x() + 0.7152F * linear.y() + 0.0722F * linear.z();
}

}  // namespace lodestone
