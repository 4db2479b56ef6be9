// From raw features to buildings with valid footprints and heights.
#pragma once

#include "model/io/footprints/vector_layer.h"

namespace lodestone {

/// Repairs all footprints and assigns heights, in parallel; buildings whose footprint cannot be repaired are
/// left out. Diagnostics: 201–204, 207, 210, 217, 218 by object, 208 as one count, 209 by object; of each
/// code the first hundred one by one, the rest as a count. \throw Cancelled
std::vector<Building> finishFootprints(LayerFeatures features, const ImportOptions& options,
                                       Diagnostics& diagnostics, const Progress& progress);

}  // namespace lodestone
