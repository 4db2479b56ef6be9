#include "model/io/hulls_layer.h"

#include <system_error>

#include "model/io/gdal_writer.h"
#include "model/io/geojson.h"
#include "model/io/output_failure.h"

namespace lodestone {

Result<WriteReport> writeHulls(const CityModel& city, const ClusterTree& tree,
                               const std::filesystem::path& path, const Progress& progress) {
  const OutlineTable table = hullTable(city, tree);
  const std::string ending = path.extension().string();
  try {
    if (ending == ".geojson" || ending == ".json") {
      writeGeoJson(path, city.crs, {table}, {}, progress);
      return WriteReport{{path}};
    }
    const std::string driver = vectorDriverFor(path);
    if (driver.empty()) return diagnose(Code::OutputFormatUnknown, path.string());
    return WriteReport{writeVector(path, driver, city.crs, {table}, {}, progress)};
  } catch (const std::system_error& error) {
    return outputFailure(error);
  }
}

}  // namespace lodestone
