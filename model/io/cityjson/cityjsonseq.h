// CityJSONSeq, a city object a line.
#pragma once

#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] Format cityJsonSeqFormat();

}  // namespace lodestone
