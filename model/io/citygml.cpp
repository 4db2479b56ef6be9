#include "model/io/citygml.h"

namespace lodestone {

Format cityGmlFormat() {
  return {"citygml", "", {}};
}

}  // namespace lodestone
