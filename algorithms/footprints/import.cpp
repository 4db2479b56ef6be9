#include "algorithms/footprints/import.h"

#include "algorithms/footprints/footprints.h"
#include "model/io/read_city.h"

namespace lodestone {

Result<CityModel> importCity(const std::vector<std::filesystem::path>& paths, const ImportOptions& options,
                             const Progress& progress, const ArtifactSink& sink) {
  Result<CityModel> result = readCity(paths, options, progress.part(0, 0.7, "read"));
  if (!result) return result;
  Diagnostics more = assignFootprints(*result, options, progress.part(0.7, 1, "footprints"));
  result.diagnostics.insert(result.diagnostics.end(), std::make_move_iterator(more.begin()),
                            std::make_move_iterator(more.end()));
  tell(sink, "import", &*result);
  return result;
}

}  // namespace lodestone
