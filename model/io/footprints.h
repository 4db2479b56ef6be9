// vector layers of footprints through GDAL (GeoJSON, Shapefile, GeoPackage, FlatGeobuf, OSM, …).
#pragma once

#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] Format footprintFormat();

}  // namespace lodestone
