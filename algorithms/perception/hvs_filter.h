// What the eye lets through of a picture (Du, Zhu and Zhao, section 3.1; resources/docs/methods.md, 5).
#pragma once

#include "algorithms/rendering/grey_image.h"
#include "model/perceive_options.h"

namespace lodestone {

/// Levels of the wavelet transform.
inline constexpr int kWaveletLevels = 5;

/// The picture with every band of its wavelet transform (CDF 9/7, kWaveletLevels levels) weighted by the
/// contrast sensitivity at the band's frequency on the display of the options. Of any size. One thread. Cost:
/// linear.
[[nodiscard]] GreyImage filterAsSeen(const GreyImage& image, const PerceiveOptions& options);

}  // namespace lodestone
