// Footprints as layers give them, made valid.
#pragma once

#include <vector>

#include "model/diagnostics.h"
#include "model/geometry.h"

namespace lodestone {

struct RepairedFootprint {
  MultiPolygon polygons;  ///< simple rings, outer counter-clockwise, holes clockwise and inside; may be empty
  std::vector<Code> codes;  ///< what was done, each once: 201, 202, 203, 204, 207, 210, 218
};

/// Removes repeated points, rings without area and holes outside; resolves crossing rings by the even-odd
/// rule and unites polygons that overlap. Rings that are plainly simple cost O(n²) cheap tests for small n;
/// everything else goes through GEOS. Deterministic and thread-safe. Works in any unit.
[[nodiscard]] RepairedFootprint repairFootprint(MultiPolygon raw);

}  // namespace lodestone
