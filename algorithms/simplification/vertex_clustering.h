// Simplification by a grid (Rossignac and Borrel 1993), to compare.
#pragma once

#include "algorithms/simplification/simplification.h"

namespace lodestone {

/// Vertices of one component that fall into one cell become the one of them that is nearest to their middle;
/// triangles with two corners in one cell go, and copies. Cells are cubes, a whole number of them along the
/// longest side of the model's box.
/// \pre cells > 0. Cost: linear but for hashing.
[[nodiscard]] Simplified clusterVertices(const ComponentMesh& mesh, std::uint32_t cells);

/// With the number of cells, up to 2^20, that leaves as near to the share 1 − `rate` of the triangles as was
/// found: by bisection, and among the 16 numbers on each side of where that ends, for the triangles left do
/// not always rise with the cells. A grid cannot meet a rate exactly. \throw Cancelled
[[nodiscard]] Simplified simplifyByClustering(const ComponentMesh& mesh, double rate,
                                              const Progress& progress = {});

}  // namespace lodestone
