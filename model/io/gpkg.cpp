#include "model/io/gpkg.h"

namespace lodestone {

Format geoPackageFormat() {
  return {"gpkg", "", {}};
}

}  // namespace lodestone
