// The colours of classes of detail, the same in pictures, plots and on the model.
#pragma once

#include <array>

#include "model/perception.h"

namespace lodestone {

/// sRGB, 0–1, from blue (nothing is filtered away) by orange to red: in the order of the classes, on white
/// and on black, and any two differ in lightness or along the blue–yellow axis, which all common kinds of
/// colour blindness leave intact.
[[nodiscard]] std::array<float, 3> detailColour(DetailClass detailClass);

/// Of triangles that no picture shows: grey, as none of the classes.
[[nodiscard]] std::array<float, 3> unseenColour();

}  // namespace lodestone
