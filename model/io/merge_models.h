// Several models made one.
#pragma once

#include <vector>

#include "model/city_model.h"
#include "model/result.h"

namespace lodestone {

/// Appends the parts in their order; CRS and origin are the first one's. Appearance indices and
/// Building::source are made to fit the joined tables. \pre all parts are in the same frame.
[[nodiscard]] CityModel mergeModels(std::vector<CityModel> parts);

/// Gives every object without an id one by its place in the model, and every later object with an id already
/// taken the suffix "_2", "_3", … (DuplicateId, the first hundred one by one, the rest as a count).
/// Deterministic: objects in model order, parents before children.
Diagnostics makeIdsUnique(CityModel& model);

}  // namespace lodestone
