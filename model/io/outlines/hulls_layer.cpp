#include "model/io/outlines/hulls_layer.h"

#include <array>
#include <string_view>
#include <system_error>

#include <cpl_string.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/io/outlines/gdal_writer.h"
#include "model/io/outlines/geojson.h"
#include "model/io/output_failure.h"

namespace lodestone {
namespace {

struct HullFormat {
  std::string_view ending;
  const char* driver;  ///< GDAL's; null: our own writer
};
// GDAL has more drivers than these, but not all of them keep polygons, their columns and their system.
constexpr std::array kFormats = std::to_array<HullFormat>({
    {".geojson", nullptr},
    {".json", nullptr},
    {".gpkg", "GPKG"},
    {".shp", "ESRI Shapefile"},
    {".fgb", "FlatGeobuf"},
    {".gml", "GML"},
    {".kml", "KML"},
});

const HullFormat* formatOf(const std::filesystem::path& path) {
  const std::string ending = CPLString(path.extension().string()).tolower();
  for (const HullFormat& format : kFormats) {
    if (format.ending == ending) return &format;
  }
  return nullptr;
}

}  // namespace

std::string hullEndings() {
  std::vector<std::string_view> endings;
  for (const HullFormat& format : kFormats) endings.push_back(format.ending);
  return fmt::format("{}", fmt::join(endings, ", "));
}

std::optional<Diagnostic> whyNoHulls(const std::filesystem::path& path) {
  if (formatOf(path)) return std::nullopt;
  return diagnose(Code::OutputFormatUnknown,
                  fmt::format("{}; hulls are written as {}", path.string(), hullEndings()));
}

Result<WriteReport> writeHulls(const CityModel& city, const ClusterTree& tree,
                               const std::filesystem::path& path, const Progress& progress) {
  if (auto why = whyNoHulls(path)) return *why;
  const OutlineTable table = hullTable(city, tree);
  const char* driver = formatOf(path)->driver;
  try {
    if (driver) return WriteReport{writeVector(path, driver, city.crs, {table}, {}, progress)};
    writeGeoJson(path, city.crs, {table}, {}, progress);
    return WriteReport{{path}};
  } catch (const std::system_error& error) {
    return outputFailure(error);
  }
}

}  // namespace lodestone
