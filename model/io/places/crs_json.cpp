#include "model/io/places/crs_json.h"

#include "model/io/places/georeference.h"

namespace lodestone {

nlohmann::ordered_json crsJson(const Crs& crs, const Vec3& origin) {
  nlohmann::ordered_json json{{"source", crs.source},
                              {"name", crs.name},
                              {"epsg", crs.epsg},
                              {"verticalEpsg", crs.verticalEpsg},
                              {"unit", crs.unit},
                              {"verticalUnit", crs.verticalUnit},
                              {"frame", projectsAboutOrigin(crs) ? "transverse mercator" : "offset"}};
  if (const std::string proj = localProjection(crs, origin); !proj.empty()) json["proj"] = proj;
  return json;
}

}  // namespace lodestone
