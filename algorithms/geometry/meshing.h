// Polygons to blocks, and polygons to triangles.
#pragma once

#include "model/lod_chain.h"

namespace lodestone {

/// A footprint extruded from base to base + height: one closed solid a polygon, with Ground, Wall and Roof
/// surfaces in this order, walls as quads. Vertices are shared within a solid; LoD "1.2". \pre rings are
/// simple, outer counter-clockwise, holes clockwise; height > 0. Cost: linear.
[[nodiscard]] Geometry makeBlock(const MultiPolygon& footprint, double base, double height);

/// Triangles of every surface, found in the coordinate plane that it faces most; orientation follows the
/// outer ring. Corners are ring vertices only, so that what was closed stays closed; rings may touch
/// themselves and each other. A surface whose rings cross is cut ear by ear as well as it goes, without its
/// holes, and its number is added to `broken` (Code::TriangulationFallback). A surface without area or with
/// coordinates that are not finite has no triangles. Cost: linear for triangles and convex rings, about n log
/// n otherwise.
[[nodiscard]] std::vector<LevelObject::Triangle> triangulate(const Geometry& geometry,
                                                             std::vector<std::uint32_t>* broken = nullptr);

/// Triangles of one polygon in the plane, as indices into outer, then the holes in turn; counter-clockwise.
/// Rings may be given either way round. `broken` is set to true where the rings cross, see above.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(const Polygon& polygon,
                                                                    bool* broken = nullptr);

}  // namespace lodestone
