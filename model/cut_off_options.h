// Where the levels that buildings bring along give way to each other (Polys et al. 2016, section 3;
// resources/docs/methods.md, 4).
#pragma once

#include "model/options.h"

namespace lodestone {

struct CutOffOptions {
  double beta = 3;        ///< scaling factor
  double plotRadius = 0;  ///< γ, metres; 0: half of the mean spacing of the buildings
  bool operator==(const CutOffOptions&) const = default;
};

template <>
const std::vector<Field<CutOffOptions>>& fields<CutOffOptions>();

}  // namespace lodestone
