// How far two surfaces are from each other.
#pragma once

#include "model/component_mesh.h"
#include "model/progress.h"

namespace lodestone {

struct Deviation {
  double forward = 0;   ///< greatest distance of a point of the first from the second, metres
  double backward = 0;  ///< and the other way round
  [[nodiscard]] double hausdorff() const { return forward > backward ? forward : backward; }
};

/// Hausdorff distance both ways, over the vertices and points strewn evenly over the triangles: `step` apart
/// (0: a two-hundredth of the diagonal), but at most 64 steps along a triangle. Never above the true
/// distance, and below it by at most the distance of two such points. 0 where both are empty, the other's
/// diagonal where one is. In parallel. Cost: O(points · log triangles). \throw Cancelled
[[nodiscard]] Deviation deviation(const ComponentMesh& first, const ComponentMesh& second, double step = 0,
                                  const Progress& progress = {});

}  // namespace lodestone
