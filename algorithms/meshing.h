// Polygons to blocks, and polygons to triangles.
#pragma once

#include "model/lod_chain.h"

namespace lodestone {

/// A footprint extruded from base to base + height as a closed solid with Ground, Wall and Roof surfaces,
/// walls as quads. Shared vertices; LoD "1.2". \pre rings are simple, outer counter-clockwise.
[[nodiscard]] Geometry makeBlock(const MultiPolygon& footprint, double base, double height);

/// Triangles of every surface by constrained triangulation in the surface's plane; a surface that cannot be
/// (too broken) becomes a fan. Orientation follows the surface's outer ring.
[[nodiscard]] std::vector<LevelObject::Triangle> triangulate(const Geometry& geometry);

/// Triangles of one polygon in the plane, as indices into outer, then the holes in turn; counter-clockwise.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(const Polygon& polygon);

}  // namespace lodestone
