#include "model/perceive_options.h"

#include <numbers>

namespace lodestone {

double PerceiveOptions::pixelsPerDegree() const {
  return distance * screenResolution / screenWidth * std::numbers::pi / 180;
}

template <>
const std::vector<Field<PerceiveOptions>>& fields<PerceiveOptions>() {
  using O = PerceiveOptions;
  static const std::vector<Field<O>> table{
      choice(&O::viewpoints, "viewpoints", "Viewpoints", {"sphere", "upper", "street"},
             "sphere looks from all directions, upper from those above the horizon, street from 1.7 m above "
             "the ground all around."),
      integer(&O::views, "views", "Views", "", 1, 1000, "Number of pictures."),
      integer(&O::size, "size", "Size", "px", 16, 8192, "Pixels of each side of a picture."),
      real(&O::screenWidth, "screen-width", "Screen width", "m", 0.02, 100,
           "Of the display that somebody looks at."),
      integer(&O::screenResolution, "screen-resolution", "Screen resolution", "px", 100, 100'000,
              "Pixels across that display."),
      real(&O::distance, "distance", "Viewing distance", "m", 0.05, 1000,
           "From the eye to the display: the farther, the less of fine detail is perceived."),
      real(&O::csf, "csf", "CSF factor c", "°", 0.02, 1,
           "Of the frequency in the contrast sensitivity function A(f) = 2.6 (0.0192 + c f) exp(−(c f)^1.1); "
           "0.114 is Mannos and Sakrison's (1974), 0.144 is what Du, Zhu and Zhao print."),
      real(&O::slight, "slight", "Slight from", "grey levels", 0, 255,
           "Least difference that counts as a slight change; 0: found by maximum likelihood."),
      real(&O::moderate, "moderate", "Moderate from", "grey levels", 0, 255,
           "Least difference that counts as a moderate change; 0: found by maximum likelihood."),
      real(&O::dramatic, "dramatic", "Dramatic from", "grey levels", 0, 255,
           "Least difference that counts as a dramatic change; 0: found by maximum likelihood."),
  };
  return table;
}

}  // namespace lodestone
