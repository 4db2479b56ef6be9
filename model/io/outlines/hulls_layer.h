// Merged hulls of every node as a vector layer: the output of `merge`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/cluster_tree.h"
#include "model/io/format.h"

namespace lodestone {

/// ".geojson, .gpkg, …": what writeHulls() writes, for people.
[[nodiscard]] std::string hullEndings();
/// Why a path cannot take hulls (OutputFormatUnknown), nothing where its ending is one of these.
[[nodiscard]] std::optional<Diagnostic> whyNoHulls(const std::filesystem::path& path);

/// One polygon a node, leaves included, with node, parent (−1 for the root), size, edges, area, negative,
/// height, base, max_top (and building: a leaf's id), in the input's CRS (KML: in degrees, as it must be).
/// The format follows the ending.
[[nodiscard]] Result<WriteReport> writeHulls(const CityModel& city, const ClusterTree& tree,
                                             const std::filesystem::path& path,
                                             const Progress& progress = {});

}  // namespace lodestone
