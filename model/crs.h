// Coordinate reference systems as the model keeps them. Resolving and transforming is in
// model/io/georeference.h.
#pragma once

#include <string>

#include "model/geometry.h"

namespace lodestone {

enum class CrsKind {
  Unknown,     ///< no CRS given: coordinates are taken as metres
  Projected,   ///< metres (or feet, turned into metres) east and north
  Geographic,  ///< degrees in the source; the model holds a local projection about the origin
  Local,       ///< an engineering CRS of the source, in metres
};

/// Where a model stands on the earth. Frame of the model: x east, y north, z up.
/// Projected, Local, Unknown: world = origin + local. Geographic: origin is (longitude, latitude, height) and
/// local x, y are the transverse Mercator projection with scale 1 centred there (conformal; 1 cm in 10 km
/// from the centre at 20 km), while local z = height − origin.z, so that a wide city does not bend below its
/// own horizon.
struct Crs {
  std::string source;  ///< as the input spells it
  std::string name;    ///< for people: "ETRS89 / UTM zone 33N"
  int epsg = 0;        ///< horizontal (or compound) code; 0 when it has none
  int verticalEpsg = 0;
  CrsKind kind = CrsKind::Unknown;
  bool operator==(const Crs&) const = default;
};

}  // namespace lodestone
