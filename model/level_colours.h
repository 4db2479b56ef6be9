// The colours of levels, the same in pictures, in exports and on screen.
#pragma once

#include <array>

#include "model/city_model.h"
#include "model/cluster_tree.h"

namespace lodestone {

/// sRGB, 0–1. Buildings are the colour of stone, clusters blue and landmarks orange: hues that people with
/// any of the usual colour vision deficiencies tell apart, and of different lightness. Roofs are lighter than
/// walls.
[[nodiscard]] std::array<float, 3> surfaceColour(DrawRole role, SurfaceType type);

/// The part of linear light that an sRGB value stands for, and back (IEC 61966-2-1).
[[nodiscard]] float toLinear(float srgb);
[[nodiscard]] float toSrgb(float linear);

}  // namespace lodestone
