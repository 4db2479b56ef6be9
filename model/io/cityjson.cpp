#include "model/io/cityjson.h"

namespace lodestone {

Format cityJsonFormat() {
  return {"cityjson", "", {}};
}

}  // namespace lodestone
