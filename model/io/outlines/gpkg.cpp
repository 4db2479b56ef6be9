#include "model/io/outlines/gpkg.h"

#include <system_error>

#include "model/io/outlines/gdal_writer.h"
#include "model/io/output_failure.h"

namespace lodestone {
namespace {

/// Level, object and building of each pair, as told while the layers are written: making an object twice
/// costs too much.
using SourceIds = std::vector<std::vector<std::string>>;

Result<WriteReport> write(const LodChain& chain, const std::filesystem::path& path,
                          const WriteOptions& options, const Progress& progress) {
  SourceIds pairs;
  std::vector<OutlineTable> tables = levelTables(chain, options.levels);
  for (OutlineTable& table : tables) {
    table.seen = [&pairs, name = table.name](const OutlineRow& row) {
      const auto& object = std::get<std::string>(row.values.front());
      for (const std::string& building : std::get<std::vector<std::string>>(row.values.back())) {
        pairs.push_back({name, object, building});
      }
    };
  }
  const PlainTable sources{"source_ids", {"level", "object", "building"}, [&](const PlainTable::Sink& sink) {
                             for (const auto& pair : pairs) sink(pair);
                           }};
  const PlainTable recipe{"recipe", {"recipe"}, [&](const PlainTable::Sink& sink) { sink({chain.recipe}); }};
  std::vector<PlainTable> plain{sources};
  if (!chain.recipe.empty()) plain.push_back(recipe);
  try {
    return WriteReport{writeVector(path, "GPKG", chain.city->crs, tables, plain, progress)};
  } catch (const std::system_error& error) {
    return outputFailure(error);
  }
}

}  // namespace

Format geoPackageFormat() {
  Format format;
  format.id = "gpkg";
  format.title = "GeoPackage outlines";
  format.extensions = {".gpkg"};
  format.write = write;
  format.losses =
      "surfaces, semantics, materials and textures: outlines, heights, attributes and ids are kept";
  return format;
}

}  // namespace lodestone
