// Buildings to triangles in components (Wang et al. 2021, section 3.1; resources/docs/methods.md, 2.1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/component_mesh.h"
#include "model/diagnostics.h"
#include "model/exterior.h"

namespace lodestone {

/// What level 0 draws of a building, by the object that it belongs to: its exteriorObjects(), else the block
/// over its footprint, which has to have a height.
[[nodiscard]] std::vector<ExteriorObject> drawnObjects(const Building& building);

/// The triangles of the drawnObjects() of some buildings of a city, as one model. Vertices of one source
/// object (a building, a part, an installation, an imported group) at one position are one; components are
/// the sets of triangles that vertices connect, in the order of their first triangle. Triangles with two
/// corners in one place, surfaces without area, and copies of a triangle of the same object are left out:
/// their number is told (Code::TrianglesDropped) with the object's id. Cost: linear but for hashing.
[[nodiscard]] ComponentMesh makeComponentMesh(const CityModel& city, std::span<const std::uint32_t> buildings,
                                              Diagnostics* diagnostics = nullptr);

}  // namespace lodestone
