// The JSON shapes of `cluster` and `cut` (resources/schemas).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/cluster_tree.h"
#include "model/result.h"

namespace lodestone {

/// \throw std::system_error
void writeDendrogram(const Dendrogram& dendrogram, const std::vector<std::string>& buildingIds,
                     const std::filesystem::path& path);
struct LoadedDendrogram {
  Dendrogram dendrogram;
  std::vector<std::string> buildings;
};
[[nodiscard]] Result<LoadedDendrogram> readDendrogram(const std::filesystem::path& path);
/// Writes the camera as it stands: bring it into the input's CRS before. \throw std::system_error
void writeCut(const Cut& cut, const std::filesystem::path& path);

}  // namespace lodestone
