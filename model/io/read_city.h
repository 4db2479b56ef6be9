// From files to one model in local metres.
#pragma once

#include "model/io/format.h"

namespace lodestone {

/// Reads all files into one model: parses each by its format, says which could not be read at all
/// (InputLeftOut), brings all coordinates into the CRS of the first, makes them local (see Crs), turns feet
/// into metres, makes ids unique. Footprints and heights of buildings with geometry are left to
/// algorithms/footprints/footprints.h. \throw Cancelled
[[nodiscard]] Result<CityModel> readCity(const std::vector<std::filesystem::path>& paths,
                                         const ImportOptions& options = {}, const Progress& progress = {});

/// Lines of any vector file (streets, rails, rivers) in the frame of `model`: of all layers of lines, of
/// files without any the outlines of their polygons, or of the layer named where a file has several
/// (LayerMissing where it has none of that name). OSM files give their highways, railways and waterways. Says
/// what was taken of which layer (BarriersTaken), and BarriersFarAway where nothing is near the buildings.
/// \throw Cancelled
[[nodiscard]] Result<LineLayer> readLines(const std::filesystem::path& path, const CityModel& model,
                                          const std::string& layer = {}, const Progress& progress = {});

}  // namespace lodestone
