// Buildings that touch, and so are one model to the building-scale methods (resources/docs/methods.md, 2.3).
#pragma once

#include <cstdint>
#include <vector>

#include "model/city_model.h"
#include "model/progress.h"

namespace lodestone {

/// Buildings whose surfaces come within `reach` metres of each other, as groups of indices into the city's
/// buildings; every building is in one group, groups and their members ascend. In parallel.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> touchingBuildings(const CityModel& city,
                                                                        double reach = 0.01,
                                                                        const Progress& progress = {});

/// The group of them that one building is in, ascending. Cost: O(n log n) over boxes, and exact distances
/// among those alone that hang together by their boxes. \throw Cancelled
[[nodiscard]] std::vector<std::uint32_t> touchingGroup(const CityModel& city, std::uint32_t building,
                                                       double reach = 0.01, const Progress& progress = {});

}  // namespace lodestone
