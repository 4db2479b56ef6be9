#include "model/io/places/georeference.h"

#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>

#include <GeographicLib/TransverseMercator.hpp>
#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>
#include <proj.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "model/io/places/crs_spelling.h"
#include "model/io/places/mercator.h"

namespace lodestone {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A resolved system, and what the frame needs of its ellipsoid.
struct Resolved {
  Crs crs;
  double equatorialRadius = 6378137;
  double flattening = 1 / 298.257223563;
  std::optional<Mercator> mercator;  ///< when it is one
};

using Srs = std::shared_ptr<OGRSpatialReference>;

Srs newSrs() {
  Srs srs(new OGRSpatialReference(), [](OGRSpatialReference* s) { s->Release(); });
  srs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return srs;
}

/// "ETRS89 / UTM zone 32N": names of the EPSG database.
bool fillByName(OGRSpatialReference& srs, const std::string& name) {
  PJ_CONTEXT* context = proj_context_create();
  proj_log_level(context, PJ_LOG_NONE);
  PJ_OBJ_LIST* found = proj_create_from_name(context, "EPSG", name.c_str(), nullptr, 0, 0, 1, nullptr);
  PJ* first = found && proj_list_get_count(found) > 0 ? proj_list_get(context, found, 0) : nullptr;
  const char* wkt =
      first && proj_is_crs(first) ? proj_as_wkt(context, first, PJ_WKT2_2019, nullptr) : nullptr;
  const bool known = wkt && srs.importFromWkt(wkt) == OGRERR_NONE;
  proj_destroy(first);
  proj_list_destroy(found);
  proj_context_destroy(context);
  return known;
}

bool fillSrs(OGRSpatialReference& srs, const CrsSpelling& spelling) {
  if (spelling.kind == CrsSpelling::Kind::Text) {
    static const char* const kNoAccess[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
    return srs.SetFromUserInput(spelling.text.c_str(), const_cast<char**>(kNoAccess)) == OGRERR_NONE ||
           fillByName(srs, spelling.text);
  }
  if (srs.importFromEPSG(spelling.horizontal) != OGRERR_NONE) return false;
  if (spelling.vertical == 0) return true;
  OGRSpatialReference vertical;
  if (vertical.importFromEPSG(spelling.vertical) != OGRERR_NONE || !vertical.IsVertical()) return true;
  OGRSpatialReference compound;
  const std::string name = std::string(srs.GetName()) + " + " + vertical.GetName();
  if (compound.SetCompoundCS(name.c_str(), &srs, &vertical) == OGRERR_NONE) srs = compound;
  return true;
}

int codeOf(const OGRSpatialReference& srs, const char* part) {
  const char* authority = srs.GetAuthorityName(part);
  const char* code = srs.GetAuthorityCode(part);
  return authority && code && std::string_view(authority) == "EPSG" ? std::atoi(code) : 0;
}

int horizontalCode(const OGRSpatialReference& srs) {
  if (const int whole = codeOf(srs, nullptr); whole != 0) return whole;
  if (const int part = codeOf(srs, srs.IsProjected() ? "PROJCS" : "GEOGCS"); part != 0 && srs.IsCompound())
    return part;
  constexpr int kConfident = 70;  // equivalent, under another name
  const std::unique_ptr<OGRSpatialReference, void (*)(OGRSpatialReference*)> best(
      srs.FindBestMatch(kConfident), [](OGRSpatialReference* s) {
        if (s) s->Release();
      });
  return best ? codeOf(*best, nullptr) : 0;
}

void describe(const OGRSpatialReference& srs, const CrsSpelling& spelling, Resolved& result) {
  OGRSpatialReference flat(srs);
  flat.StripVertical();
  Crs& crs = result.crs;
  crs.name = srs.GetName() ? srs.GetName() : "";
  if (spelling.kind == CrsSpelling::Kind::Epsg) {
    crs.epsg = spelling.horizontal;
    crs.verticalEpsg = srs.IsCompound() ? spelling.vertical : 0;
  } else {
    crs.epsg = horizontalCode(srs);
    if (srs.IsCompound() && codeOf(srs, nullptr) == 0) crs.verticalEpsg = codeOf(srs, "VERT_CS");
  }
  if (flat.IsGeographic() || flat.IsGeocentric()) {
    crs.kind = CrsKind::Geographic;
    if (flat.IsGeographic()) crs.unit = flat.GetAngularUnits(static_cast<const char**>(nullptr)) / kDegree;
    // PROJ's radians-a-degree has its own last digit.
    if (std::abs(crs.unit - 1) < 1e-9) crs.unit = 1;
  } else if (flat.IsProjected()) {
    crs.kind = CrsKind::Projected;
    crs.unit = flat.GetLinearUnits(static_cast<const char**>(nullptr));
    crs.verticalUnit = crs.unit;
  } else {
    crs.kind = CrsKind::Local;
    crs.unit = flat.GetLinearUnits(static_cast<const char**>(nullptr));
    crs.verticalUnit = crs.unit;
  }
  if (srs.IsCompound())
    crs.verticalUnit = srs.GetTargetLinearUnits("VERT_CS", static_cast<const char**>(nullptr));
  result.equatorialRadius = srs.GetSemiMajor();
  const double inverse = srs.GetInvFlattening();
  result.flattening = inverse > 0 ? 1 / inverse : 0;
  result.mercator = Mercator::from(flat);
}

Resolved resolve(const std::string& source) {
  Resolved result;
  result.crs.source = source;
  const CrsSpelling spelling = parseCrs(source);
  if (spelling.kind == CrsSpelling::Kind::Local) {
    result.crs.kind = CrsKind::Local;
    result.crs.name = spelling.text;
  }
  if (spelling.kind == CrsSpelling::Kind::None || spelling.kind == CrsSpelling::Kind::Local) return result;

  CPLPushErrorHandler(CPLQuietErrorHandler);
  const Srs srs = newSrs();
  if (fillSrs(*srs, spelling)) {
    describe(*srs, spelling, result);
  }
  CPLPopErrorHandler();
  return result;
}

// Looking a system up costs about a millisecond; files and frames ask for the same few again and again.
const Resolved& remembered(const std::string& source) {
  static std::mutex mutex;
  static std::map<std::string, Resolved, std::less<>> known;
  const std::scoped_lock lock(mutex);
  const auto found = known.find(source);
  return found != known.end() ? found->second : known.emplace(source, resolve(source)).first->second;
}

}  // namespace

Crs resolveCrs(const std::string& spelling) {
  return remembered(spelling).crs;
}

std::optional<Diagnostic> whyNoSystem(const std::string& spelling) {
  const CrsSpelling said = parseCrs(spelling);
  if (said.kind == CrsSpelling::Kind::None) return std::nullopt;
  const Crs crs = resolveCrs(spelling);
  const bool wholeCode = said.vertical == 0 || crs.verticalEpsg == said.vertical;
  if (wholeCode && (crs.kind == CrsKind::Projected || crs.kind == CrsKind::Geographic)) return std::nullopt;
  return diagnose(Code::OptionBadValue,
                  "crs is " + spelling +
                      ", wanted EPSG:N with a code of the EPSG database (EPSG:25833; with heights "
                      "EPSG:25833+7837), a URN or URL of one, a name, WKT or a PROJ string");
}

Srs spatialReference(const Crs& crs) {
  if (crs.kind == CrsKind::Unknown || crs.kind == CrsKind::Local) return nullptr;
  CPLPushErrorHandler(CPLQuietErrorHandler);
  Srs srs = newSrs();
  // From the spelling and not from WKT: that keeps the codes of a compound system's parts.
  const bool known = fillSrs(*srs, parseCrs(crs.source));
  CPLPopErrorHandler();
  if (!known) return nullptr;
  srs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return srs;
}

Srs horizontalReference(const Crs& crs) {
  Srs srs = spatialReference(crs);
  if (!srs) return nullptr;
  srs->StripVertical();
  if (srs->GetAxesCount() == 3) srs->DemoteTo2D(nullptr);
  srs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return srs;
}

bool projectsAboutOrigin(const Crs& crs) {
  return crs.kind == CrsKind::Geographic ||
         (crs.kind == CrsKind::Projected && remembered(crs.source).mercator.has_value());
}

std::string localProjection(const Crs& crs, const Vec3& origin) {
  if (!projectsAboutOrigin(crs)) return {};
  const Resolved& known = remembered(crs.source);
  const Vec2 degrees = known.mercator ? known.mercator->toDegrees(origin.head<2>()) : Vec2(origin.head<2>());
  return fmt::format("+proj=tmerc +lat_0={} +lon_0={} +k=1 +x_0=0 +y_0=0 +a={} +f={} +units=m +no_defs",
                     degrees.y(), degrees.x(), known.equatorialRadius, known.flattening);
}

/// Between world units times `Crs::unit` (degrees, or metres of a Mercator projection) and local metres.
struct Frame::Projection {
  Projection(const Resolved& resolved, const Vec2& origin)
      : transverse(resolved.equatorialRadius, resolved.flattening, 1), mercator(resolved.mercator) {
    const Vec2 degrees = mercator ? mercator->toDegrees(origin) : origin;
    longitude = degrees.x();
    double x = 0;
    transverse.Forward(longitude, degrees.y(), longitude, x, northing);
  }

  [[nodiscard]] Vec2 toLocal(const Vec2& world) const {
    const Vec2 degrees = mercator ? mercator->toDegrees(world) : world;
    Vec2 local;
    transverse.Forward(longitude, degrees.y(), degrees.x(), local.x(), local.y());
    local.y() -= northing;
    return local;
  }

  [[nodiscard]] Vec2 toWorld(const Vec2& local) const {
    Vec2 degrees;
    transverse.Reverse(longitude, local.x(), local.y() + northing, degrees.y(), degrees.x());
    if (!mercator) return degrees;
    // A map goes on beyond the date line.
    degrees.x() += 360 * std::round((longitude - degrees.x()) / 360);
    return mercator->toMetres(degrees);
  }

  GeographicLib::TransverseMercator transverse;
  std::optional<Mercator> mercator;
  double longitude = 0;
  double northing = 0;  ///< of the origin
};

Frame::Frame(const Crs& crs, const Vec3& origin)
    : origin_(origin), unit_(crs.unit), verticalUnit_(crs.verticalUnit) {
  if (!projectsAboutOrigin(crs)) return;
  projection_ = std::make_shared<const Projection>(remembered(crs.source), origin.head<2>());
}

Vec2 Frame::toWorld(const Vec2& local) const {
  return (projection_ ? projection_->toWorld(local) : Vec2(local + origin_.head<2>())) / unit_;
}

Vec2 Frame::toLocal(const Vec2& world) const {
  const Vec2 scaled = world * unit_;
  return projection_ ? projection_->toLocal(scaled) : Vec2(scaled - origin_.head<2>());
}

Vec3 Frame::toWorld(const Vec3& local) const {
  const Vec2 plan = toWorld(Vec2(local.head<2>()));
  return {plan.x(), plan.y(), (local.z() + origin_.z()) / verticalUnit_};
}

Vec3 Frame::toLocal(const Vec3& world) const {
  const Vec2 plan = toLocal(Vec2(world.head<2>()));
  return {plan.x(), plan.y(), world.z() * verticalUnit_ - origin_.z()};
}

Vec3 toWorld(const CityModel& model, const Vec3& local) {
  return Frame(model).toWorld(local);
}
Vec3 toLocal(const CityModel& model, const Vec3& world) {
  return Frame(model).toLocal(world);
}

namespace {

template <class Map>
void mapAll(std::span<Vec3> points, const Map& map) {
  constexpr std::size_t kGrain = 1024;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), kGrain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) points[i] = map(points[i]);
  });
}

}  // namespace

void toWorld(const CityModel& model, std::span<Vec3> points) {
  const Frame frame(model);
  mapAll(points, [&](const Vec3& p) { return frame.toWorld(p); });
}

void toLocal(const CityModel& model, std::span<Vec3> points) {
  const Frame frame(model);
  mapAll(points, [&](const Vec3& p) { return frame.toLocal(p); });
}

}  // namespace lodestone
