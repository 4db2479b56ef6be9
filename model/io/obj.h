// Wavefront OBJ with MTL.
#pragma once

#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] Format objFormat();

}  // namespace lodestone
