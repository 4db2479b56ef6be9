// Coordinate reference systems as the model keeps them. Resolving and transforming is in
// model/io/places/georeference.h.
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

/// Where a model stands on the earth. Frame of the model: x east, y north, z up, metres.
/// Projected, Local, Unknown: world = (origin + local) / unit, z by verticalUnit. Geographic: origin is
/// (longitude, latitude, height) and local x, y are the transverse Mercator projection with scale 1 centred
/// there, while local z = height − origin.z. So it is of Mercator projections, whose own metres are none on
/// the ground; their origin is origin / unit in the world. Transverse Mercator is conformal; its scale grows
/// by x²/2R²: 1.2 mm a kilometre at 10 km east or west of the centre, 31 mm at 50 km, none along the
/// meridian.
struct Crs {
  std::string source;    ///< as the input spells it
  std::string name;      ///< for people: "ETRS89 / UTM zone 33N"
  int epsg = 0;          ///< horizontal (or compound) code; 0 when it has none
  int verticalEpsg = 0;  ///< 0 when there is none, and when `epsg` is a compound code
  CrsKind kind = CrsKind::Unknown;
  double unit = 1;          ///< metres (geographic: degrees) in one horizontal unit of the source
  double verticalUnit = 1;  ///< metres in one vertical unit of the source
  bool operator==(const Crs&) const = default;
};

}  // namespace lodestone
