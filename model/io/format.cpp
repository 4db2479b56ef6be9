#include "model/io/format.h"

#include <algorithm>
#include <cctype>

#include "model/io/citygml/citygml.h"
#include "model/io/cityjson/cityjson.h"
#include "model/io/cityjson/cityjsonseq.h"
#include "model/io/footprints/footprints.h"
#include "model/io/input_file.h"
#include "model/io/meshes/glb.h"
#include "model/io/meshes/mesh_import.h"
#include "model/io/meshes/obj.h"
#include "model/io/outlines/geojson.h"
#include "model/io/outlines/gpkg.h"

namespace lodestone {
namespace {

std::string lowerName(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

bool hasExtension(const Format& format, const std::string& name) {
  return std::any_of(format.extensions.begin(), format.extensions.end(),
                     [&](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

std::span<const Format> formats() {
  static const std::vector<Format> all{
      cityGmlFormat(), cityJsonFormat(), cityJsonSeqFormat(), glbFormat(),
      objFormat(),     plyFormat(),      stlFormat(),         colladaFormat(),
      offFormat(),     geoJsonFormat(),  geoPackageFormat(),  footprintFormat(),
  };
  return all;
}

const Format* formatById(std::string_view id) {
  for (const Format& format : formats()) {
    if (format.id == id) return &format;
  }
  return nullptr;
}

const Format* formatForWriting(const std::filesystem::path& path) {
  const std::string name = lowerName(path);
  const Format* best = nullptr;
  std::size_t longest = 0;
  for (const Format& format : formats()) {
    if (!format.write) continue;
    for (std::string_view ending : format.extensions) {
      if (name.ends_with(ending) && ending.size() > longest) {
        best = &format;
        longest = ending.size();
      }
    }
  }
  return best;
}

const Format* formatForReading(const std::filesystem::path& path) {
  const std::string head = readHead(path);
  const std::string name = lowerName(path);
  const Format* best = nullptr;
  int bestScore = 0;
  for (const Format& format : formats()) {
    if (!format.read || !format.probe) continue;
    const int score = 2 * format.probe(path, head) + (hasExtension(format, name) ? 1 : 0);
    if (score > bestScore && score > 1) {
      best = &format;
      bestScore = score;
    }
  }
  return best;
}

}  // namespace lodestone
