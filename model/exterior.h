// What a building looks like from outside: the geometry that its level 0 is drawn with.
#pragma once

#include <limits>
#include <vector>

#include "model/city_model.h"
#include "model/face_count.h"

namespace lodestone {

/// The finest exterior geometry of a building: of each object (itself, parts, installations; never rooms and
/// furniture) the solids of its finest LoD, else that LoD's surfaces, without interior walls, floors and
/// ceilings. A building whose parts are finer than itself is drawn by its parts alone. LoD 0 (outlines),
/// curves and points do not count; a geometry that names no LoD counts as LoD 1. Empty where there is nothing
/// of the kind.
[[nodiscard]] std::vector<Geometry> exteriorGeometry(const CityObject& building);

/// The same, by the object that each geometry belongs to: the building, a part, an installation. Objects
/// without a geometry of their own are left out.
struct ExteriorObject {
  const CityObject* object = nullptr;
  std::vector<Geometry> geometries;
};
[[nodiscard]] std::vector<ExteriorObject> exteriorObjects(const CityObject& building);

/// Surfaces that only somebody within a building sees.
[[nodiscard]] bool isInterior(SurfaceType type);

/// Faces of a building as level 0 draws it: its exteriorGeometry(), else the block over its footprint, which
/// has to have a height. No geometry is copied. `finest`: as if there were no LoD of a higher rank.
[[nodiscard]] FaceCount facesOf(const Building& building,
                                double finest = std::numeric_limits<double>::infinity());

/// Ranks of the LoDs that a building has an exteriorGeometry() of, by itself or by its parts; ascending.
[[nodiscard]] std::vector<double> exteriorRanks(const CityObject& building);

}  // namespace lodestone
