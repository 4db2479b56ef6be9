// Outline tables through any of GDAL's vector drivers.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/io/outlines/outline_table.h"
#include "model/result.h"

namespace lodestone {

/// A table without geometry, filled by a function that is called once with a sink for its rows.
struct PlainTable {
  std::string name;
  std::vector<std::string> columns;  ///< all of text
  using Sink = std::function<void(const std::vector<std::string>&)>;
  std::function<void(const Sink&)> fill;
};

/// Writes one layer a table by GDAL's `driver`, then the plain tables where the driver has room for them.
/// Written in a folder beside and renamed, side files included, so that nothing half-done is left; times
/// inside the file are fixed, so that the same input gives the same bytes. Returns the files, the main one
/// first. \throw std::system_error (also with GDAL's own words), Cancelled
std::vector<std::filesystem::path> writeVector(const std::filesystem::path& path, const std::string& driver,
                                               const Crs& crs, const std::vector<OutlineTable>& tables,
                                               const std::vector<PlainTable>& plain,
                                               const Progress& progress);

}  // namespace lodestone
