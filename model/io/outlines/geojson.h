// GeoJSON of plan outlines.
//
// RFC 7946 knows longitude and latitude on WGS 84 alone. A city stays in the system it came in, as GDAL
// writes it: with the `crs` member of GeoJSON 2008, which GDAL and QGIS read; `null` where the system is
// unknown. Coordinates are x east, y north.
#pragma once

#include <filesystem>

#include "model/io/format.h"
#include "model/io/outlines/outline_table.h"

namespace lodestone {

[[nodiscard]] Format geoJsonFormat();

/// One FeatureCollection of the rows of all tables. `recipe`: JSON text kept as a member, or empty. Written
/// beside and renamed; the same bytes for the same input. \throw std::system_error, Cancelled
void writeGeoJson(const std::filesystem::path& path, const Crs& crs, const std::vector<OutlineTable>& tables,
                  const std::string& recipe, const Progress& progress);

}  // namespace lodestone
