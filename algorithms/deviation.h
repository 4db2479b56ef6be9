// How far two meshes lie apart (resources/docs/methods.md, 2.4).
#pragma once

#include "model/component_mesh.h"
#include "model/progress.h"

namespace lodestone {

/// Greatest distance of a point of one surface to the other, metres.
struct Deviation {
  double forward = 0;   ///< from the first to the second
  double backward = 0;  ///< from the second to the first
  [[nodiscard]] double hausdorff() const { return forward > backward ? forward : backward; }
};

/// Hausdorff distance both ways: never above the true distance, and below it by at most `accuracy` metres (0:
/// a thousandth of the diagonal). Triangles are cut in four where one of them could hold a farther point,
/// which the distance to a single triangle of the other mesh, a convex function, bounds by its corners (after
/// Tang, Lee and Kim 2009); a triangle that was cut 4096 times is let be. 0 where both meshes are empty, the
/// other's diagonal where one is. In parallel, the same for any number of threads. Cost: about O(n log n).
/// \throw Cancelled
[[nodiscard]] Deviation deviation(const ComponentMesh& first, const ComponentMesh& second,
                                  double accuracy = 0, const Progress& progress = {});

}  // namespace lodestone
