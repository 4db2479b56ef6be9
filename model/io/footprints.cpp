#include "model/io/footprints.h"

namespace lodestone {

Format footprintFormat() {
  return {"footprints", "", {}};
}

}  // namespace lodestone
