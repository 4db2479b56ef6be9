// The biorthogonal wavelet transform CDF 9/7 (Cohen, Daubechies and Feauveau 1992) of pictures, by lifting
// (Daubechies and Sweldens 1998: Factoring Wavelet Transforms into Lifting Steps, section 7.7).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lodestone {

/// A rectangle of coefficients of one kind, in pixels of the transformed picture.
struct WaveletBand {
  /// Low or high frequencies across (first letter) and down (second): HL answers to upright edges.
  enum class Kind : std::uint8_t { LL, HL, LH, HH };
  int level = 1;  ///< 1: the finest
  Kind kind = Kind::LL;
  int x = 0, y = 0, width = 0, height = 0;
};

/// The bands of a transformed picture in Mallat's layout: what is low stands left and above. From the finest
/// level on, HL, LH, HH each, the approximation (LL) last; those that are empty are left out. They cover the
/// picture. A side of one pixel is divided no further while the other side goes on, so that there can be
/// fewer levels. None for an empty picture.
[[nodiscard]] std::vector<WaveletBand> waveletBands(int width, int height, int levels);

/// Replaces pixels (rows) by their coefficients, and these by the pixels again. Pictures of any size go on
/// beyond their sides as in a mirror that stands on the last pixel. Low-pass filters keep what is even as it
/// is, high-pass ones double the highest frequency (as JPEG 2000 scales them, ITU-T T.800). There and back
/// again is the same to about 1e-6 of the range. One thread. Cost: linear.
/// \pre pixels.size() is width · height
void forwardWavelet(std::span<float> pixels, int width, int height, int levels);
void inverseWavelet(std::span<float> pixels, int width, int height, int levels);

}  // namespace lodestone
