// CityGML 1.0, 2.0 and 3.0, streamed.
#pragma once

#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] Format cityGmlFormat();

}  // namespace lodestone
