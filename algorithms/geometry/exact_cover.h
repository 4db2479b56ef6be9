// What a set of rings covers, in exact arithmetic (CGAL behind a plain header).
#pragma once

#include <vector>

#include "model/geometry.h"

namespace lodestone {

enum class CoverRule {
  EvenOdd,   ///< inside where the rings wind an odd number of times
  Positive,  ///< inside where they wind more often counter-clockwise than clockwise
};

/// The covered part of the plane as polygons with holes. Rings may meet, overlap and cross themselves and
/// each other. Crossings are computed exactly and rounded to doubles at the end. Cost: a constrained
/// triangulation in exact arithmetic, about 10 µs a vertex and more where many edges cross.
[[nodiscard]] MultiPolygon cover(const std::vector<Ring>& rings, CoverRule rule);

}  // namespace lodestone
