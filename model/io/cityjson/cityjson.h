// CityJSON 1.0, 1.1 and 2.0.
#pragma once

#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] Format cityJsonFormat();

}  // namespace lodestone
