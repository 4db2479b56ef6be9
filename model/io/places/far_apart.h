// Inputs that can hardly be meant to make one model.
#pragma once

#include "model/city_model.h"
#include "model/diagnostics.h"

namespace lodestone {

/// InputsFarApart for each group of sources whose buildings stand more than 20 km from those of the others,
/// as boxes in plan: no city's tiles have such a gap, while a wrong or missing coordinate system moves a file
/// by hundreds. The group with the most buildings is where the others are far from. \pre localise() was
/// called. Cost: one pass over all vertices, and the square of the number of sources.
[[nodiscard]] Diagnostics sayFarApart(const CityModel& model);

}  // namespace lodestone
