// A picture as the eye's filter takes it.
#pragma once

#include <vector>

namespace lodestone {

/// Rows from the top, display-encoded grey (sRGB's curve), 0–255.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<float> pixels;
};

}  // namespace lodestone
