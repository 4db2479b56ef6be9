#include "model/io/glb.h"

namespace lodestone {

Format glbFormat() {
  return {"glb", "", {}};
}

}  // namespace lodestone
