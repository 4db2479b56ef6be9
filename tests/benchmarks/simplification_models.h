// Made-up models for the simplification benchmark.
#pragma once

#include "algorithms/geometry/components.h"

namespace lodestone::test {

/// 400 bumpy blocks on a grid, each sunk a little into its neighbours: 100,800 triangles.
[[nodiscard]] CityModel manyPartedBuilding();

/// Gabled LoD2 houses in rows of one to six that touch.
[[nodiscard]] CityModel rowsOfHouses(int houses);

/// With a texture laid on from six sides, a repetition a metre: charts end where the surface turns to another
/// side.
[[nodiscard]] ComponentMesh boxMapped(ComponentMesh mesh);

}  // namespace lodestone::test
