// Merged hulls of every node as a vector layer: the output of `merge`.
#pragma once

#include <filesystem>

#include "model/cluster_tree.h"
#include "model/io/format.h"

namespace lodestone {

/// One polygon a node, leaves included, with node, parent (−1 for the root), size, edges, area, negative,
/// height, base, max_top (and building: a leaf's id), in the input's CRS. By ending: .geojson, .gpkg, or any
/// vector format GDAL writes.
[[nodiscard]] Result<WriteReport> writeHulls(const CityModel& city, const ClusterTree& tree,
                                             const std::filesystem::path& path,
                                             const Progress& progress = {});

}  // namespace lodestone
