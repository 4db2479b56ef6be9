// Heights of buildings from their attributes.
#pragma once

#include "model/city_model.h"
#include "model/import_options.h"
#include "model/result.h"

namespace lodestone {

/// Sets height and heightSource of a building whose geometry gave no height: from the field or number of
/// `options.height`, else the usual height fields, else floors × floor height, else the default. Heights of
/// zero or less are refused.
void assignHeightFromAttributes(Building& building, const ImportOptions& options, Diagnostics& diagnostics);

}  // namespace lodestone
