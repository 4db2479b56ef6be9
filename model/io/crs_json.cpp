#include "model/io/crs_json.h"

#include "model/io/georeference.h"

namespace lodestone {

nlohmann::ordered_json crsJson(const Crs& crs) {
  return {{"source", crs.source},
          {"name", crs.name},
          {"epsg", crs.epsg},
          {"verticalEpsg", crs.verticalEpsg},
          {"unit", crs.unit},
          {"verticalUnit", crs.verticalUnit},
          {"frame", projectsAboutOrigin(crs) ? "transverse mercator" : "offset"}};
}

}  // namespace lodestone
