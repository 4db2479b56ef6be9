// Boundary, hole and ordinary vertices (Wang et al. 2021, section 3.2; resources/docs/methods.md, 2.2).
#pragma once

#include "model/component_mesh.h"
#include "model/progress.h"

namespace lodestone {

/// Of the model's diagonal: points so near count as one. Single-precision files are no better.
inline constexpr double kContactNoise = 1e-6;

/// Classes of all vertices; `gap` is the share of its length by which each end of an edge is lengthened.
/// Component pairs come from a tree over their boxes, triangles from a tree for each component that has a
/// neighbour. Contacts within kContactNoise count as touching. In parallel over components, the same result
/// for any number of threads. Cost: about n log n for n triangles and as many contacts. \throw Cancelled
[[nodiscard]] Classification classify(const ComponentMesh& mesh, double gap = 0.01,
                                      const Progress& progress = {});

}  // namespace lodestone
