// Vector layers of footprints through GDAL (GeoJSON, Shapefile, GeoPackage, FlatGeobuf, OSM, …).
//
// - Layers: the one named in ImportOptions::layer, else the first polygon layer whose name speaks of
// buildings, else the
//   first polygon layer. Of an archive, that of every member: tiles are read as one layer.
// - Geometry: polygons of any nesting; curves are made straight. A feature with upright surfaces (MultiPatch,
//   PolyhedralSurface, multipolygons with walls) is a body and keeps its surfaces; all others are plan
//   outlines, made valid (footprint_repair.h).
// - Heights: the body's own, else by footprint_heights.h. The z of a plan outline is its ground; where
// nothing else says how
//   high a building is, a z range of 2 m or more is taken for its height.
// - OSM: areas tagged building=* but not "no"; building:part alone is not a building.
// - CRS: that of the layer. GeoJSON without a `crs` member is longitude, latitude, unless its numbers cannot
// be.
#pragma once

#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] Format footprintFormat();

}  // namespace lodestone
