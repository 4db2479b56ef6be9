// GeoPackage of plan outlines, one layer a level.
#pragma once

#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] Format geoPackageFormat();

}  // namespace lodestone
