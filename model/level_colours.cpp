#include "model/level_colours.h"

#include <algorithm>
#include <cmath>

namespace lodestone {
namespace {

using Colour = std::array<float, 3>;

Colour wallColour(DrawRole role) {
  switch (role) {
    case DrawRole::Cluster:
      return {0.47F, 0.60F, 0.75F};
    case DrawRole::Landmark:
      return {0.87F, 0.56F, 0.25F};
    case DrawRole::Building:
      break;
  }
  return {0.82F, 0.78F, 0.71F};
}

Colour towards(const Colour& from, const Colour& to, float share) {
  Colour result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = from[i] + (to[i] - from[i]) * share;
  return result;
}

}  // namespace

Colour surfaceColour(DrawRole role, SurfaceType type) {
  constexpr Colour kWhite{1, 1, 1};
  constexpr Colour kShade{0.35F, 0.34F, 0.33F};
  const Colour wall = wallColour(role);
  switch (type) {
    case SurfaceType::Roof:
      return towards(wall, kWhite, 0.38F);
    case SurfaceType::Ground:
    case SurfaceType::OuterCeiling:
      return towards(wall, kShade, 0.35F);
    case SurfaceType::Window:
      return {0.42F, 0.52F, 0.60F};
    case SurfaceType::Door:
      return {0.50F, 0.40F, 0.33F};
    default:
      return wall;
  }
}

float toLinear(float srgb) {
  return srgb <= 0.04045F ? srgb / 12.92F : std::pow((srgb + 0.055F) / 1.055F, 2.4F);
}

float toSrgb(float linear) {
  const float x = std::clamp(linear, 0.F, 1.F);
  return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
}

}  // namespace lodestone
