// settleCrs() of georeference.h: what system a model stands in, and which of its axes is which.
#include <algorithm>
#include <cmath>

#include <GeographicLib/Geocentric.hpp>
#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>
#include <tbb/parallel_for.h>

#include "model/io/places/crs_spelling.h"
#include "model/io/places/georeference.h"
#include "model/io/places/model_places.h"

namespace lodestone {
namespace {

// A building of 2 km is a hall, one of 2 cm is none: coordinates of smaller things are degrees.
constexpr double kDegreesPerBuilding = 0.02;

bool lookGeographic(const std::vector<Box2>& boxes) {
  std::vector<double> sizes;
  for (const Box2& box : boxes) {
    if (!box.empty()) sizes.push_back(box.size().maxCoeff());
  }
  if (sizes.empty()) return false;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  if (*middle <= 0 || *middle > kDegreesPerBuilding) return false;
  const Box2 all = unionOf(boxes, {});
  return all.min.x() >= -180 && all.max.x() <= 180 && all.min.y() >= -90 && all.max.y() <= 90;
}

/// Longitude and latitude range for which a system is meant, with a margin for data just outside.
struct AreaOfUse {
  Box2 box;
  [[nodiscard]] bool contains(const Vec2& p) const {
    constexpr double kMargin = 1;
    if (p.y() < box.min.y() - kMargin || p.y() > box.max.y() + kMargin) return false;
    const bool acrossDateLine = box.min.x() > box.max.x();
    const bool eastOf = p.x() >= box.min.x() - kMargin;
    const bool westOf = p.x() <= box.max.x() + kMargin;
    return acrossDateLine ? eastOf || westOf : eastOf && westOf;
  }
};

// Taken from the database anew: the parts of a compound system come without it.
AreaOfUse areaOf(const Crs& crs) {
  AreaOfUse area{{Vec2(-180, -90), Vec2(180, 90)}};
  OGRSpatialReference srs;
  if (crs.epsg == 0 || srs.importFromEPSG(crs.epsg) != OGRERR_NONE) return area;
  Vec2 low;
  Vec2 high;
  constexpr double kUnknown = -1000;
  if (srs.GetAreaOfUse(&low.x(), &low.y(), &high.x(), &high.y(), nullptr) && low.x() > kUnknown)
    area.box = {low, high};
  return area;
}

bool inArea(const AreaOfUse& area, OGRCoordinateTransformation* toDegrees, Vec2 p) {
  if (toDegrees && !toDegrees->Transform(1, &p.x(), &p.y())) return false;
  return p.allFinite() && area.contains(p);
}

Transformation toDegreesFrom(const Crs& crs) {
  return crs.kind == CrsKind::Geographic ? nullptr : transformation(crs, resolveCrs("EPSG:4326"));
}

/// Says it when the centre of the data is no place for the system.
void checkArea(const Crs& crs, const Vec2& centre, const std::string& place, Diagnostics& diagnostics) {
  const Transformation toDegrees = toDegreesFrom(crs);
  if (crs.kind != CrsKind::Geographic && !toDegrees) return;
  if (inArea(areaOf(crs), toDegrees.get(), toDegrees ? centre : Vec2(centre * crs.unit))) return;
  diagnostics.push_back(diagnose(Code::OutsideAreaOfUse,
                                 fmt::format("{} at {:.6g}, {:.6g}", crs.name, centre.x(), centre.y()), {},
                                 place));
}

/// Whether the coordinates stand north before east; see the rule in georeference.h.
bool northFirst(const Crs& crs, const Vec2& centre) {
  const auto srs = horizontalReference(crs);
  if (!srs) return false;
  const bool geographic = crs.kind == CrsKind::Geographic;
  OGRAxisOrientation first = OAO_Other;
  if (!srs->GetAxis(nullptr, 0, &first) || first != OAO_North) return false;
  const bool chosen = geographic && !parseCrs(crs.source).eastFirst;
  const AreaOfUse area = areaOf(crs);
  const Transformation toDegrees = toDegreesFrom(crs);
  if (!geographic && !toDegrees) return chosen;
  const auto fits = [&](bool north) {
    const Vec2 p = north ? Vec2(centre.y(), centre.x()) : centre;
    return inArea(area, toDegrees.get(), geographic ? Vec2(p * crs.unit) : p);
  };
  return !fits(chosen) && fits(!chosen) ? !chosen : chosen;
}

void swapAxes(CityModel& model, const std::vector<Places>& all) {
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
    forEachVertex(
        all[i], [](Vec3& p) { std::swap(p.x(), p.y()); }, [](Vec2& p) { std::swap(p.x(), p.y()); });
    if (!all[i].building) return;
    for (Polygon& polygon : all[i].building->footprint) {
      tidyRing(polygon.outer, true);
      for (Ring& hole : polygon.holes) tidyRing(hole, false);
    }
  });
  for (LineLayer& layer : model.lines) {
    for (auto& line : layer.lines) {
      for (Vec2& p : line) std::swap(p.x(), p.y());
    }
  }
}

void fromEarthCentred(CityModel& model, const std::vector<Places>& all, const OGRSpatialReference& srs) {
  const GeographicLib::Geocentric earth(srs.GetSemiMajor(), 1 / srs.GetInvFlattening());
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
    forEachVertex(
        all[i],
        [&](Vec3& p) {
          double latitude = 0;
          double longitude = 0;
          double height = 0;
          earth.Reverse(p.x(), p.y(), p.z(), latitude, longitude, height);
          p = Vec3(longitude, latitude, height);
        },
        [](const Vec2&) {});
  });
  // 3D geographic systems of the same frames: ETRS89 and WGS 84.
  constexpr int kEtrs89EarthCentred = 4936;
  model.crs = resolveCrs(model.crs.epsg == kEtrs89EarthCentred ? "EPSG:4937" : "EPSG:4979");
}

/// Says how long a unit of a Mercator projection is on the ground: in Berlin 0.61 m.
void sayStraightened(const Crs& crs, const Vec2& centre, const std::string& place, Diagnostics& diagnostics) {
  if (crs.kind != CrsKind::Projected || !projectsAboutOrigin(crs)) return;
  const Vec2 origin = centre * crs.unit;
  const double unit = Frame(crs, {origin.x(), origin.y(), 0}).toLocal(Vec2(centre + Vec2(1, 0))).norm();
  diagnostics.push_back(diagnose(Code::MercatorStraightened,
                                 fmt::format("1 unit of {} is {:.3f} m there", crs.name, unit), {}, place));
}

}  // namespace

Diagnostics settleCrs(CityModel& model, const std::string& override, bool eastNorth) {
  Diagnostics diagnostics;
  const std::string given = override.empty() ? model.crs.source : override;
  const std::string place = model.sources.empty() ? std::string() : model.sources.front().path;
  model.crs = resolveCrs(given);
  const std::vector<Places> all = placesOf(model);
  const std::vector<Box2> boxes = boxesOf(all);
  if (model.crs.kind == CrsKind::Unknown) {
    if (!given.empty()) diagnostics.push_back(diagnose(Code::CrsUnknown, given, {}, place));
    if (lookGeographic(boxes)) {
      diagnostics.push_back(diagnose(Code::CoordinatesLookGeographic, {}, {}, place));
      model.crs = resolveCrs("EPSG:4326");
    } else if (given.empty()) {
      diagnostics.push_back(diagnose(Code::CrsMissing, {}, {}, place));
    }
    return diagnostics;
  }
  const Box2 extent = unionOf(boxes, model.lines);
  if (extent.empty()) return diagnostics;
  CPLPushErrorHandler(CPLQuietErrorHandler);
  const auto srs = spatialReference(model.crs);
  Vec2 centre = extent.center();
  if (!eastNorth && srs && srs->IsGeocentric()) {
    fromEarthCentred(model, all, *srs);
    diagnostics.push_back(diagnose(Code::UnitsConverted,
                                   "earth-centred coordinates to longitude, latitude and height", {}, place));
  } else {
    if (!eastNorth && srs && northFirst(model.crs, centre)) {
      swapAxes(model, all);
      std::swap(centre.x(), centre.y());
    }
    checkArea(model.crs, centre, place, diagnostics);
    sayStraightened(model.crs, centre, place, diagnostics);
  }
  CPLPopErrorHandler();
  return diagnostics;
}

}  // namespace lodestone
