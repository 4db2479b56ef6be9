// Coordinate reference systems: resolving, axis order, and the map between a source's coordinates and a
// model's metres.
//
// World coordinates here and everywhere are in the order x = east or longitude, y = north or latitude, z =
// height, in the units of the source, whatever order the source writes them in. The order of a source is
// settled like this:
//   - vector layers (GeoJSON, Shapefile, GeoPackage, OSM …) come from GDAL as east, north;
//   - projected systems are taken as east, north, as cities are written in the wild even where the authority
//   says
//     northing first (Gauss-Krüger, Soldner Berlin, Japan's plane rectangular systems);
//   - geographic systems are taken in the authority's order (latitude first: PLATEAU's EPSG:6697), but as
//   longitude,
//     latitude when the spelling is the short "EPSG:N" or CRS84, as in GML 2;
//   - where the authority writes north first, the coordinates can prove the choice wrong: when the centre of
//   the data
//     lies outside the system's area of use as chosen and inside it the other way round, the other order is
//     taken.
// South-orientated grids (EPSG:2053 …) keep their axes: the model is turned by 180°.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/city_model.h"
#include "model/progress.h"
#include "model/result.h"

class OGRSpatialReference;

namespace lodestone {

/// Resolves any spelling that crs_spelling.h knows, WKT and PROJ strings. An empty spelling, and one that
/// nobody knows, give CrsKind::Unknown with `source` kept. Results are remembered: repeated calls cost a
/// look-up. Thread-safe.
[[nodiscard]] Crs resolveCrs(const std::string& spelling);

/// Why a person's choice of a system cannot be taken (OptionBadValue), nothing where it can: what nobody
/// knows, and vertical systems alone. Empty is no choice.
[[nodiscard]] std::optional<Diagnostic> whyNoSystem(const std::string& spelling);

/// The system as GDAL has it, axes in east-north order; null for Unknown and Local. A copy of the caller's
/// own.
[[nodiscard]] std::shared_ptr<OGRSpatialReference> spatialReference(const Crs& crs);
/// The horizontal part alone. Null as above.
[[nodiscard]] std::shared_ptr<OGRSpatialReference> horizontalReference(const Crs& crs);

/// Whether the local metres are a transverse Mercator projection about the origin, and not the source's own
/// coordinates less the origin: of geographic systems, and of Mercator projections (EPSG:3857), which show
/// lengths 1/cos(latitude) too long.
[[nodiscard]] bool projectsAboutOrigin(const Crs& crs);

/// PROJ string of the local metres about `origin` where they are that projection, to put them back with any
/// GIS; empty where world = (origin + local) / unit.
[[nodiscard]] std::string localProjection(const Crs& crs, const Vec3& origin);

/// The map between a model's local metres and world coordinates (source CRS, x east, y north). Exact inverses
/// of each other to 1e-7 m within 1000 km. Cheap to copy; thread-safe.
class Frame {
 public:
  Frame(const Crs& crs, const Vec3& origin);
  explicit Frame(const CityModel& model) : Frame(model.crs, model.origin) {}

  [[nodiscard]] Vec3 toWorld(const Vec3& local) const;
  [[nodiscard]] Vec3 toLocal(const Vec3& world) const;
  [[nodiscard]] Vec2 toWorld(const Vec2& local) const;
  [[nodiscard]] Vec2 toLocal(const Vec2& world) const;

 private:
  struct Projection;
  Vec3 origin_;
  double unit_;
  double verticalUnit_;
  std::shared_ptr<const Projection> projection_;  ///< where projectsAboutOrigin(), else null
};

[[nodiscard]] Vec3 toWorld(const CityModel& model, const Vec3& local);
[[nodiscard]] Vec3 toLocal(const CityModel& model, const Vec3& world);
/// In place, in parallel.
void toWorld(const CityModel& model, std::span<Vec3> points);
void toLocal(const CityModel& model, std::span<Vec3> points);

/// First step of a model fresh from a reader: resolves `crs.source` (or `override`, if not empty), brings the
/// axes into east-north order, turns earth-centred coordinates into longitude, latitude, height; says
/// CrsMissing, CrsUnknown, CoordinatesLookGeographic (no system, but buildings smaller than 0.02 units at
/// places within ±180, ±90: taken as EPSG:4326), OutsideAreaOfUse (by the centre of the data, 1° of margin).
/// MercatorStraightened (with the length on the ground of a unit at the centre). `eastNorth`: the reader
/// already gives east, north.
Diagnostics settleCrs(CityModel& model, const std::string& override, bool eastNorth);

/// Second step, of several models: brings world coordinates into the system `target`; heights change units
/// alone, since geoid models are not at hand offline. Objects that cannot be transformed are left out
/// (CrsTransformFailed). Does nothing where one of the systems is unknown or local, or both are the same.
Diagnostics reproject(CityModel& model, const Crs& target);

/// Last step: subtracts an origin, turns feet into metres (UnitsConverted) and degrees, and the metres
/// of a Mercator projection, into a local transverse Mercator projection (see Crs). The origin is the centre
/// of the extent, rounded down to whole metres (to 1e-5 degrees); 0 for unknown and local systems within 100
/// km of 0. origin.z is always 0: z stays the height that the source states. Objects with coordinates that
/// are not finite, or no place on earth, are left out (CoordinateBad). \pre settleCrs() was called. In
/// parallel. \throw Cancelled
Diagnostics localise(CityModel& model, const Progress& progress = {});

}  // namespace lodestone
