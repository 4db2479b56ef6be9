#include "model/detail_colours.h"

namespace lodestone {

std::array<float, 3> detailColour(DetailClass detailClass) {
  switch (detailClass) {
    case DetailClass::Slight:
      return {0.54F, 0.77F, 0.90F};
    case DetailClass::Moderate:
      return {0.96F, 0.65F, 0.25F};
    case DetailClass::Dramatic:
      return {0.80F, 0.16F, 0.14F};
    case DetailClass::None:
      break;
  }
  return {0.17F, 0.44F, 0.70F};
}

std::array<float, 3> unseenColour() {
  return {0.52F, 0.52F, 0.52F};
}

}  // namespace lodestone
