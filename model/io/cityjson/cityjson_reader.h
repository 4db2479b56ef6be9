// Reading CityJSON and CityJSONSeq: both are lists of JSON documents, of which the first has no more than
// one.
#pragma once

#include <filesystem>

#include "model/io/format.h"

namespace lodestone {

/// Reads CityJSON 1.0 to 2.0 (0.9 as far as it agrees) and CityJSONSeq, packed or not; a document or a line
/// that cannot be understood is said and left out. `format` is the id recorded in the model's source. \throw
/// Cancelled
[[nodiscard]] Result<CityModel> readCityJsonDocuments(const std::filesystem::path& path,
                                                      std::string_view format, const ImportOptions& options,
                                                      const Progress& progress);

/// The same for text in memory; `name` is where the text came from, for messages and image paths.
[[nodiscard]] Result<CityModel> parseCityJson(std::string text, const std::filesystem::path& name,
                                              std::string_view format, const ImportOptions& options = {},
                                              const Progress& progress = {});

}  // namespace lodestone
