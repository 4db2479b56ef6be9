// Ground that overlapping buildings share, for the union areas of clusters.
#pragma once

#include <vector>

#include "model/dendrogram.h"
#include "model/footprint_table.h"
#include "model/progress.h"

namespace lodestone {

/// For each node the area that lies both under buildings of its child a and under buildings of its child b,
/// so that area of union(node) = area of union(a) + area of union(b) − sharedGround[node]. 0 for leaves. In
/// parallel, the same for any number of threads. Cost: about O(n log n) while footprints overlap in small
/// groups. The result is short when `progress` was asked to stop.
[[nodiscard]] std::vector<double> sharedGround(const FootprintTable& footprints, const Dendrogram& dendrogram,
                                               const Progress& progress = {});

}  // namespace lodestone
