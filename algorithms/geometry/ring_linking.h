// From directed boundary edges to polygons.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

using DirectedEdge = std::array<std::uint32_t, 2>;

/// Polygons bounded by edges that have the inside on their left. Where several boundaries meet in a vertex
/// they part there, so that no ring passes a vertex twice. Vertices in the middle of a straight side are
/// dropped. Ordered by the outer rings' smallest vertices, the same for any order of the edges. \pre every
/// vertex has as many edges in as out, and edges meet only in their ends.
[[nodiscard]] MultiPolygon linkRings(const std::vector<Vec2>& points, const std::vector<DirectedEdge>& edges);

}  // namespace lodestone
