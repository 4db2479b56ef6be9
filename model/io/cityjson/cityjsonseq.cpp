#include "model/io/cityjson/cityjsonseq.h"

#include "model/io/cityjson/cityjson_reader.h"
#include "model/io/cityjson/cityjson_writer.h"

namespace lodestone {
namespace {

int probe(const std::filesystem::path&, std::string_view head) {
  const std::size_t lineEnd = head.find('\n');
  if (head.find("\"CityJSONFeature\"") != std::string_view::npos) return 95;
  // A header line that is a whole CityJSON document, and more lines after it.
  const bool whole = lineEnd != std::string_view::npos &&
                     head.substr(0, lineEnd).find("\"CityJSON\"") != std::string_view::npos;
  const bool more = whole && head.find('{', lineEnd) != std::string_view::npos;
  const bool closed =
      more && head.substr(0, lineEnd).find_last_not_of(" \t\r") == head.substr(0, lineEnd).rfind('}');
  return closed && head.substr(0, lineEnd).find("\"CityObjects\"") != std::string_view::npos ? 95 : 0;
}

Result<CityModel> read(const std::filesystem::path& path, const ImportOptions& options,
                       const Progress& progress) {
  return readCityJsonDocuments(path, "cityjsonseq", options, progress);
}

}  // namespace

Format cityJsonSeqFormat() {
  Format format;
  format.id = "cityjsonseq";
  format.title = "CityJSONSeq 1.1, 2.0";
  format.extensions = {".city.jsonl", ".jsonl"};
  format.probe = probe;
  format.read = read;
  format.write = writeCityJsonSeq;
  format.losses = kCityJsonLosses;
  return format;
}

}  // namespace lodestone
