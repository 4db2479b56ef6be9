// Footprints and heights of buildings that came with geometry (resources/docs/methods.md 1.1).
#pragma once

#include "model/city_model.h"
#include "model/import_options.h"
#include "model/progress.h"
#include "model/result.h"

namespace lodestone {

/// Gives every building that has none a footprint and a height, in place, in parallel. The footprint is the
/// union of the ground surfaces of the building and its parts, else the outline of its geometry projected
/// down, taken from the finest LoD that is not an interior. A building made of installations alone, as an
/// imported mesh is, gets the convex hull of that outline. Base and height come from the geometry (lowest and
/// highest vertex of that LoD), else from attributes by the rule of footprints (HeightRule), else the
/// default. Rings are tidied: no repeated or collinear duplicates, outer counter-clockwise, holes clockwise;
/// invalid ones are repaired by the even-odd rule. Returns diagnostics, in building order. \throw Cancelled
Diagnostics assignFootprints(CityModel& model, const ImportOptions& options, const Progress& progress = {});

/// The polygon as it is, tidied, if it is valid; else what it covers by the even-odd rule. Empty when nothing
/// is left.
[[nodiscard]] MultiPolygon repaired(const Polygon& polygon);

/// Union of polygons that may touch, overlap or cross themselves, as polygons with holes. Fast where shared
/// edges cancel, exact arithmetic (CGAL) otherwise.
[[nodiscard]] MultiPolygon unite(const MultiPolygon& polygons);

}  // namespace lodestone
