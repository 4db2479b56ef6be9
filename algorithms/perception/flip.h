// ꟻLIP: how different two pictures are for somebody who flips between them (Andersson, Nilsson,
// Akenine-Möller, Oskarsson, Åström, Fairchild 2020: FLIP: A Difference Evaluator for Alternating Images).
#pragma once

#include <vector>

#include "algorithms/rendering/rendering.h"
#include "model/progress.h"

namespace lodestone {

struct FlipMap {
  int width = 0;
  int height = 0;
  std::vector<float> errors;  ///< rows from the top, 0 (equal) to 1
  double mean = 0;
};

/// LDR-ꟻLIP of two pictures (sRGB; alpha is not looked at) at so many pixels per degree. In parallel, the
/// same for any number of threads. Cost: O(pixels · pixels per degree). \pre the pictures are of one size
/// \throw Cancelled
[[nodiscard]] FlipMap flip(const Picture& reference, const Picture& test, double pixelsPerDegree,
                           const Progress& progress = {});

/// The map in the colours of magma: black where the pictures are equal, white where nothing agrees.
[[nodiscard]] Picture flipPicture(const FlipMap& map);

/// The share of pixels that differ, as Chang et al. measure (Legible Cities, figure 3): at all, in any
/// channel. \pre the pictures are of one size
[[nodiscard]] double pixelError(const Picture& reference, const Picture& test);

}  // namespace lodestone
