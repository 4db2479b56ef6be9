// Writing chains as CityJSON 2.0 and CityJSONSeq.
#pragma once

#include "model/io/format.h"

namespace lodestone {

/// What CityJSON, or the model on the way to it, has no place for.
constexpr const char* kCityJsonLosses =
    "streets and other line layers; attributes of single surfaces; metadata beyond title and reference "
    "system; the points of addresses; all themes of an appearance but one; LoD 4 is written as LoD 3; "
    "generic "
    "surfaces lose their kind";

/// Streams the chosen levels into one file, whole or not at all: memory follows the largest batch of objects.
/// Every building is written once, with its parts and their geometries (LodLevel::isCity), else with those of the levels
/// that draw it by itself. Clusters become CityObjectGroup with their buildings as `children`, the block as
/// geometry, and the attributes lodestone:level, :node, :negative, :base, :height and :landmarks. The recipe
/// and the levels' names, errors and switch distances stand in the member "+lodestone". \throw Cancelled
[[nodiscard]] Result<WriteReport> writeCityJson(const LodChain& chain, const std::filesystem::path& path,
                                                const WriteOptions& options, const Progress& progress);
/// The same as CityJSONSeq: a header, then one feature a line.
[[nodiscard]] Result<WriteReport> writeCityJsonSeq(const LodChain& chain, const std::filesystem::path& path,
                                                   const WriteOptions& options, const Progress& progress);

}  // namespace lodestone
