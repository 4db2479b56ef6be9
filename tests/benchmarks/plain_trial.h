// The peer of clustering and merging.
#pragma once

#include "model/footprint_table.h"

namespace lodestone {

/// Clusters as one would who writes it in an afternoon: a uniform grid searched ring by ring for the k = 50
/// nearest buildings on all cores, a vector of neighbours for each building, rounds of joining mutual choices
/// with sorted vectors on one core; no spanning tree, single precision, no ties, no progress.
/// \returns the depth of its tree.
int runPlainTrial(const FootprintTable& table);

}  // namespace lodestone
