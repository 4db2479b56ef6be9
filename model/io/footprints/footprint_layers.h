// Which layers a vector data set has, and which of them holds the footprints.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/io/footprints/vector_layer.h"
#include "model/result.h"

class GDALDataset;

namespace lodestone {

[[nodiscard]] LayerKind layerKind(GDALDataset& dataset);

/// The layer to read: the one that is named (LayerMissing where it is not there), else the first of polygons
/// whose name speaks of buildings, else the first of polygons. OSM has its buildings in one layer. Says
/// which, where there was a choice. `place`: the file, for messages. The layer lives as long as the data set.
[[nodiscard]] Result<OGRLayer*> chooseLayer(GDALDataset& dataset, const std::string& wanted,
                                            const std::string& place);

struct LayerEntry {
  std::string name;
  std::string geometry;  ///< OGR's name: "Multi Polygon", "Unknown (any)"; "None" for a plain table
  std::int64_t features = 0;
  bool read = false;  ///< the one that chooseLayer() takes
};

/// All layers of a footprint file, of an archive those of every member; `wanted` as for chooseLayer(). Empty
/// for files that GDAL does not open. Cost: of most formats, a look at their tables of contents; OSM and text
/// are read through. \throw Cancelled
[[nodiscard]] std::vector<LayerEntry> listLayers(const std::filesystem::path& path, const std::string& wanted,
                                                 const Progress& progress = {});

}  // namespace lodestone
