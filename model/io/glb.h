// binary glTF 2.0.
#pragma once

#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] Format glbFormat();

}  // namespace lodestone
