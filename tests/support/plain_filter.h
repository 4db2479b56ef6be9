// What the eye lets through, by the slow transform.
#pragma once

#include <vector>

#include "algorithms/perception/contrast_sensitivity.h"
#include "algorithms/perception/hvs_filter.h"
#include "tests/support/plain_wavelet.h"

namespace lodestone {

/// Every coefficient by itself: how often a quarter must be taken until it is outside says its level.
inline std::vector<double> plainlyFiltered(const GreyImage& image, const PerceiveOptions& options) {
  PlainPicture plain{static_cast<std::size_t>(image.width),
                     static_cast<std::size_t>(image.height),
                     {image.pixels.begin(), image.pixels.end()}};
  plainTransform(plain, kWaveletLevels, false);
  for (std::size_t y = 0; y < plain.height; ++y) {
    for (std::size_t x = 0; x < plain.width; ++x) {
      std::size_t width = plain.width;
      std::size_t height = plain.height;
      for (int level = 1; level <= kWaveletLevels; ++level) {
        width = (width + 1) / 2;
        height = (height + 1) / 2;
        if (x < width && y < height) continue;
        plain.pixels[y * plain.width + x] *=
            bandWeight(level, x >= width && y >= height, options.pixelsPerDegree(), options.csf);
        break;
      }
    }
  }
  plainTransform(plain, kWaveletLevels, true);
  return plain.pixels;
}

}  // namespace lodestone
