#include "model/io/cityjson/cityjson.h"

#include "model/io/cityjson/cityjson_reader.h"
#include "model/io/cityjson/cityjson_writer.h"

namespace lodestone {
namespace {

// "type" may stand anywhere in the file: of a big one the beginning is all there is to see.
int probe(const std::filesystem::path&, std::string_view head) {
  if (head.find("\"CityJSONFeature\"") != std::string_view::npos) return 60;
  if (head.find("\"CityJSON\"") != std::string_view::npos) return 90;
  const bool likely = head.find("\"CityObjects\"") != std::string_view::npos ||
                      head.find("\"geographicalExtent\"") != std::string_view::npos;
  return likely ? 50 : 0;
}

Result<CityModel> read(const std::filesystem::path& path, const ImportOptions& options,
                       const Progress& progress) {
  return readCityJsonDocuments(path, "cityjson", options, progress);
}

}  // namespace

Format cityJsonFormat() {
  Format format;
  format.id = "cityjson";
  format.title = "CityJSON 1.0, 1.1, 2.0";
  format.extensions = {".city.json", ".json"};
  format.probe = probe;
  format.read = read;
  format.write = writeCityJson;
  format.losses = kCityJsonLosses;
  return format;
}

}  // namespace lodestone
