#include "model/cut_off_options.h"

namespace lodestone {

template <>
const std::vector<Field<CutOffOptions>>& fields<CutOffOptions>() {
  using O = CutOffOptions;
  static const std::vector<Field<O>> table{
      real(&O::beta, "beta", "Scaling factor β", "", 0.01, 100,
           "Of the distances at which levels give way, Y(x) = α · β · γ^x with the building's diagonal α "
           "(Polys "
           "et al. 2016)."),
      real(&O::plotRadius, "plot-radius", "Plot radius γ", "m", 0, 10'000,
           "Half of the diagonal of a building's plot. 0: half of the mean spacing of the buildings."),
  };
  return table;
}

}  // namespace lodestone
