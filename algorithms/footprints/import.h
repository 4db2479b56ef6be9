// The whole way in: files to a model with footprints and heights.
#pragma once

#include <filesystem>
#include <vector>

#include "model/artifacts.h"
#include "model/import_options.h"
#include "model/progress.h"
#include "model/result.h"

namespace lodestone {

/// readCity() and assignFootprints(). \throw Cancelled
[[nodiscard]] Result<CityModel> importCity(const std::vector<std::filesystem::path>& paths,
                                           const ImportOptions& options = {}, const Progress& progress = {},
                                           const ArtifactSink& sink = {});

}  // namespace lodestone
