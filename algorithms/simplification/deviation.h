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
/// a four-hundredth of the diagonal). The triangle that may hold the farthest point is cut in four, again and
/// again: the distance to a single triangle of the other mesh, a convex function, bounds that of a piece by
/// its corners (after Tang, Lee and Kim 2009). Given up after a million cuts, which no building has needed. 0
/// where both meshes are empty, the other's diagonal where one is. Bounds are found in parallel; the same for
/// any number of threads. Cost: about O(n log n). \throw Cancelled
[[nodiscard]] Deviation deviation(const ComponentMesh& first, const ComponentMesh& second,
                                  double accuracy = 0, const Progress& progress = {});

/// The greater of the two alone, for less: the way back is searched only for what is farther than the way
/// there.
[[nodiscard]] double hausdorffDistance(const ComponentMesh& first, const ComponentMesh& second,
                                       double accuracy = 0, const Progress& progress = {});

}  // namespace lodestone
