#include "model/io/obj.h"

namespace lodestone {

Format objFormat() {
  return {"obj", "", {}};
}

}  // namespace lodestone
