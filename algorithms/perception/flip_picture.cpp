#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/perception/flip.h"

namespace lodestone {
namespace {

/// Evenly spaced colours of magma (Smith and van der Walt, 2015); between them its curve is nearly straight.
constexpr std::array<std::array<float, 3>, 9> kMagma{{{0, 0, 4},
                                                      {29, 17, 71},
                                                      {81, 18, 124},
                                                      {130, 38, 129},
                                                      {182, 54, 121},
                                                      {230, 81, 100},
                                                      {251, 136, 97},
                                                      {254, 194, 135},
                                                      {252, 253, 191}}};

std::array<std::uint8_t, 3> magma(float error) {
  const float place = std::clamp(error, 0.0F, 1.0F) * (kMagma.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kMagma.size() - 2);
  const float share = place - static_cast<float>(below);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] =
        static_cast<std::uint8_t>(std::lround((1 - share) * kMagma[below][c] + share * kMagma[below + 1][c]));
  return colour;
}

}  // namespace

Picture flipPicture(const FlipMap& map) {
  Picture picture{map.width, map.height, {}};
  picture.rgba.reserve(4 * map.errors.size());
  for (const float error : map.errors) {
    const auto colour = magma(error);
    picture.rgba.insert(picture.rgba.end(), {colour[0], colour[1], colour[2], 255});
  }
  return picture;
}

double pixelError(const Picture& reference, const Picture& test) {
  const std::size_t pixels = reference.rgba.size() / 4;
  if (pixels == 0) return 0;
  std::size_t different = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto* a = &reference.rgba[4 * i];
    different += std::equal(a, a + 4, &test.rgba[4 * i]) ? 0 : 1;
  }
  return static_cast<double>(different) / static_cast<double>(pixels);
}

}  // namespace lodestone
