// GeoJSON of plan outlines.
#pragma once

#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] Format geoJsonFormat();

}  // namespace lodestone
