#include "model/io/geojson.h"

namespace lodestone {

Format geoJsonFormat() {
  return {"geojson", "", {}};
}

}  // namespace lodestone
