// Random numbers for made-up cities: integers alone, so that they are the same with every compiler.
#pragma once

#include <cstdint>

namespace lodestone {

/// SplitMix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", OOPSLA 2014).
class SynthRandom {
 public:
  explicit SynthRandom(std::uint64_t seed) : state_(seed) {}
  /// A generator of its own for one place of the plan, so that no district depends on what another drew.
  SynthRandom(std::uint64_t seed, std::int64_t x, std::int64_t y)
      : state_(seed * 0x9E3779B97F4A7C15U + static_cast<std::uint64_t>(x) * 0xD1B54A32D192ED03U +
               static_cast<std::uint64_t>(y) * 0x8CB92BA72F3D8DD7U) {
    (void)next();
  }

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }
  /// Uniform in [low, high], both included. \pre low ≤ high
  int between(int low, int high) {
    const auto span = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(((next() >> 32U) * span) >> 32U);
  }
  bool chance(int percent) { return between(0, 99) < percent; }
  /// Uniform in [0, 1), a multiple of 2⁻³².
  double unit() { return static_cast<double>(next() >> 32U) / 4294967296.0; }

 private:
  std::uint64_t state_;
};

}  // namespace lodestone
