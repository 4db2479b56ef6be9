// A coordinate reference system as JSON, for exports in local metres.
#pragma once

#include <nlohmann/json.hpp>

#include "model/crs.h"

namespace lodestone {

/// All that a reader needs to get from local metres back to the world: `frame` is "offset" where
/// world = (origin + local) / unit, "transverse mercator" where the metres are that projection about the
/// origin (see Crs), and then `proj` is its PROJ string.
[[nodiscard]] nlohmann::ordered_json crsJson(const Crs& crs, const Vec3& origin);

}  // namespace lodestone
