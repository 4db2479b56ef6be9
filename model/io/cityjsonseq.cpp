#include "model/io/cityjsonseq.h"

namespace lodestone {

Format cityJsonSeqFormat() {
  return {"cityjsonseq", "", {}};
}

}  // namespace lodestone
