// GeoPackage of plan outlines: one layer a level, in the system of the input; a table `source_ids` (level,
// object, building) that leads from every object down to its buildings; a table `recipe` with the text that
// makes the chain again.
#pragma once

#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] Format geoPackageFormat();

}  // namespace lodestone
