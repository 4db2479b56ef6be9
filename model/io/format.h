// The formats Lodestone reads and writes, listed once for the command line, the workbench and the tests.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/city_model.h"
#include "model/import_options.h"
#include "model/lod_chain.h"
#include "model/progress.h"
#include "model/result.h"

namespace lodestone {

struct WriteOptions {
  std::vector<std::size_t> levels;  ///< levels to write; empty: all
};

/// Files that a writer made, in the order of making, each complete.
struct WriteReport {
  std::vector<std::filesystem::path> files;
};

struct Format {
  std::string_view id;                       ///< "citygml"
  std::string_view title;                    ///< "CityGML 1.0, 2.0, 3.0"
  std::vector<std::string_view> extensions;  ///< with the dot, lower case: ".gml"; the first is the usual one

  /// 0: not this format; 100: certain. `head` is the (unpacked) beginning of the file, at most 4096 bytes.
  int (*probe)(const std::filesystem::path& path, std::string_view head) = nullptr;
  /// Reads one file into a model in the coordinates of the source, as they stand, crs.source filled and
  /// origin 0: readCity() brings them into the local frame. Null: cannot be read.
  Result<CityModel> (*read)(const std::filesystem::path& path, const ImportOptions& options,
                            const Progress& progress) = nullptr;
  /// Writes the chain to `path` (a file), whole or not at all. Null: cannot be written.
  Result<WriteReport> (*write)(const LodChain& chain, const std::filesystem::path& path,
                               const WriteOptions& options, const Progress& progress) = nullptr;
  /// What the format cannot hold, in words; empty: nothing of what a chain has.
  std::string_view losses;
  bool fileALevel = false;  ///< a chain is one file a level
  /// Import options (by name) that are for some formats alone, this one among them.
  std::vector<std::string_view> listensTo;
};

[[nodiscard]] std::span<const Format> formats();
[[nodiscard]] const Format* formatById(std::string_view id);
/// The format that a file to be written has by its ending; null if none can be written.
[[nodiscard]] const Format* formatForWriting(const std::filesystem::path& path);
/// The format that reads the file, by content first and ending second; null if none.
[[nodiscard]] const Format* formatForReading(const std::filesystem::path& path);

}  // namespace lodestone
