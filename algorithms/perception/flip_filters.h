// The filters of ꟻLIP (Andersson et al. 2020, sections 4.1.1 and 4.2.1) as filters of one dimension: every
// one of theirs is a product of two, or a sum of two such products.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace lodestone {

/// A filter of one dimension, the same on both sides of its middle or, where it is odd, with opposite sign.
struct HalfFilter {
  std::vector<float> taps;  ///< from the middle outwards
  bool odd = false;
};

/// Along rows or columns of a picture.
struct FlipFilters {
  // Of the eye's contrast sensitivity to light and dark, red and green, blue and yellow (a sum of two).
  HalfFilter lightness;
  HalfFilter redGreen;
  std::array<HalfFilter, 2> blueYellow;
  // Of the detector of edges and points: a Gaussian and its derivatives.
  HalfFilter gaussian;
  HalfFilter edge;
  HalfFilter point;

  /// Taps on each side of the middle of the widest.
  [[nodiscard]] std::size_t reach() const;
};

/// For pictures that are `length` pixels long and go on as they end. Taps that never meet anything else than
/// what lies beyond an end are summed into one: no filter is wider than the picture, however many pixels a
/// degree has. Cost: linear in the pixels per degree.
[[nodiscard]] FlipFilters flipFilters(double pixelsPerDegree, std::size_t length);

/// What is filtered: sources[k] and sources[-k] are the rows of floats that meet tap k.
using TapRows = const float* const*;

/// out[i] = Σ tap[k] · (rows[k][i] ± rows[−k][i]). Cost: count · taps.
void applyFilter(const HalfFilter& filter, TapRows rows, std::size_t count, float* out);
/// The same, added to what `out` holds.
void addFilter(const HalfFilter& filter, TapRows rows, std::size_t count, float* out);

}  // namespace lodestone
