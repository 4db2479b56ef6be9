// Roots and powers that compilers turn into vector instructions: straight lines of arithmetic, so that the
// results do not depend on a mathematical library either.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace lodestone {

/// Within 3e-7 of its value. \pre 1e-20 < x < 1e20
inline float cubeRoot(float x) {
  constexpr std::uint32_t kOne = std::bit_cast<std::uint32_t>(1.0F);
  // The exponent divided by three, within 6%; Halley's method cubes the error.
  float root = std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) / 3 + (kOne - kOne / 3));
  for (int i = 0; i < 2; ++i) {
    const float cube = root * root * root;
    root = root * (cube + 2 * x) / (2 * cube + x);
  }
  return root;
}

/// Binary logarithm within 3e-7 of itself or of 1. \pre x ≥ 1e-37
inline float binaryLogarithm(float x) {
  constexpr std::uint32_t kRootHalf = 0x3f3504f3U;  // of the mantissas, those from √½ to √2
  const std::uint32_t above = std::bit_cast<std::uint32_t>(x) - kRootHalf;
  const auto exponent = static_cast<std::int32_t>(above) >> 23;
  const float mantissa = std::bit_cast<float>((above & 0x007fffffU) + kRootHalf);
  // ln m = 2 artanh s
  const float s = (mantissa - 1) / (mantissa + 1);
  const float s2 = s * s;
  const float series = 1 + s2 * (1.0F / 3 + s2 * (1.0F / 5 + s2 * (1.0F / 7 + s2 * (1.0F / 9))));
  return static_cast<float>(exponent) + 2.885390082F * s * series;
}

/// 2^x within 3e-7 of its value; of x below −126 that of −126. \pre x < 127
inline float powerOfTwo(float x) {
  constexpr float kShift = 12582912;  // 1.5 · 2^23: what is added and taken away again is rounded
  const float bounded = std::max(x, -126.0F);
  const float whole = (bounded + kShift) - kShift;
  const float t = 0.6931471806F * (bounded - whole);
  const float series =
      1 + t * (1 + t * (1.0F / 2 +
                        t * (1.0F / 6 +
                             t * (1.0F / 24 + t * (1.0F / 120 + t * (1.0F / 720 + t * (1.0F / 5040)))))));
  const auto exponent = static_cast<std::uint32_t>(static_cast<std::int32_t>(whole) + 127);
  return series * std::bit_cast<float>(exponent << 23);
}

/// x^power within 2e-6 of its value; 0 of x below 1e-37. \pre 0 ≤ x < 1e30, 0 ≤ power ≤ 1
inline float raised(float x, float power) {
  constexpr float kLeast = 1e-37F;
  const float result = powerOfTwo(power * binaryLogarithm(std::max(x, kLeast)));
  return x < kLeast ? 0 : result;
}

}  // namespace lodestone
