// The parts of meshing that need CGAL, behind a plain header since CGAL's cost minutes of compile time.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

using IndexTriangle = std::array<std::uint32_t, 3>;

/// Constrained Delaunay triangulation of the inside (even-odd) of rings that may touch and overlap but not
/// cross. Ring r has the points [ringStart[r], ringStart[r+1]); outer rings are counter-clockwise, holes
/// clockwise. Where several ring points share a place, each corner names the one whose ring it lies in.
/// Appends counter-clockwise triangles and returns true; returns false, with nothing appended, when edges
/// cross. \pre coordinates are finite.
[[nodiscard]] bool constrainedTriangulation(std::span<const Vec2> points,
                                            std::span<const std::uint32_t> ringStart,
                                            std::vector<IndexTriangle>& triangles);

}  // namespace lodestone
