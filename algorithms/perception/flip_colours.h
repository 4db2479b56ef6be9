// The colour spaces of ꟻLIP (Andersson et al. 2020, sections 4.1 and 4.1.2): an opponent space that is linear
// in light, in which pictures are filtered, and one of even steps to the eye, in which they are compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lodestone {

/// Rows of one picture in YCxCz without its constants, which cancel out around a linear filter: of XYZ over
/// the white point's, Y, X − Y and Y − Z.
struct OpponentRow {
  float* y;
  float* cx;
  float* cz;
};

/// 8-bit sRGB with alpha, which is not looked at.
void toOpponent(const std::uint8_t* rgba, std::size_t count, const OpponentRow& out);

/// Colour differences 0–1 of two filtered rows (ΔE_c, equation 6): HyAB between L*a*b* adjusted for the Hunt
/// effect, its exponent, and the redistribution of its range.
void colourDifferences(const OpponentRow& reference, const OpponentRow& test, std::size_t count, float* out);

}  // namespace lodestone
