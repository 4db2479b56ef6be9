// Heights of buildings from their attributes.
#pragma once

#include "model/city_model.h"
#include "model/io/footprints/footprint_heights.h"
#include "model/result.h"

namespace lodestone {

/// Sets height and heightSource of a building whose geometry gave no height by the rule of footprints
/// (HeightRule).
void assignHeightFromAttributes(Building& building, const HeightRule& rule, Diagnostics& diagnostics);

}  // namespace lodestone
