// The three steps of georeference.h that turn a whole model.
#include <algorithm>
#include <atomic>
#include <cmath>

#include <GeographicLib/Geocentric.hpp>
#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>
#include <tbb/parallel_for.h>

#include "model/io/crs_spelling.h"
#include "model/io/georeference.h"

namespace lodestone {
namespace {

// A building of 2 km is a hall, one of 2 cm is none: coordinates of smaller things are degrees.
constexpr double kDegreesPerBuilding = 0.02;
constexpr double kNearZero = 1e5;

/// Places of one object: vertices of its geometries and of its children's, and of its footprint if it is a
/// building.
struct Places {
  CityObject* object;
  Building* building;  ///< null for others
};

std::vector<Places> placesOf(CityModel& model) {
  std::vector<Places> result;
  result.reserve(model.buildings.size() + model.others.size());
  for (Building& building : model.buildings) result.push_back({&building.object, &building});
  for (CityObject& object : model.others) result.push_back({&object, nullptr});
  return result;
}

template <class InSpace, class InPlan>
void forEachVertex(const Places& places, const InSpace& inSpace, const InPlan& inPlan) {
  forEachObject(*places.object, [&](auto& object) {
    for (Geometry& geometry : object.geometries) {
      for (Vec3& vertex : geometry.vertices) inSpace(vertex);
    }
  });
  if (!places.building) return;
  for (Polygon& polygon : places.building->footprint) {
    for (Vec2& vertex : polygon.outer) inPlan(vertex);
    for (Ring& hole : polygon.holes) {
      for (Vec2& vertex : hole) inPlan(vertex);
    }
  }
}

Box2 planBounds(const Places& places) {
  Box2 box;
  const auto add = [&](const Vec2& p) {
    if (p.allFinite()) box.add(p);
  };
  forEachVertex(
      places, [&](const Vec3& p) { add(p.head<2>()); }, add);
  return box;
}

std::vector<Box2> boxesOf(const std::vector<Places>& all) {
  std::vector<Box2> boxes(all.size());
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) { boxes[i] = planBounds(all[i]); });
  return boxes;
}

Box2 unionOf(const std::vector<Box2>& boxes, const std::vector<LineLayer>& lines) {
  Box2 all;
  for (const Box2& box : boxes) {
    if (!box.empty()) all.add(box);
  }
  if (!all.empty()) return all;
  for (const LineLayer& layer : lines) {
    for (const auto& line : layer.lines) {
      for (const Vec2& p : line) {
        if (p.allFinite()) all.add(p);
      }
    }
  }
  return all;
}

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

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

Transformation transformation(const Crs& from, const Crs& to) {
  const auto source = horizontalReference(from);
  const auto target = horizontalReference(to);
  if (!source || !target) return nullptr;
  return Transformation(OGRCreateCoordinateTransformation(source.get(), target.get()));
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

/// Leaves out the objects of which `bad[i]` is set (in the order of placesOf) and says so.
void leaveOut(CityModel& model, const std::vector<std::uint8_t>& bad, Code code, const std::string& why,
              Diagnostics& diagnostics) {
  if (std::none_of(bad.begin(), bad.end(), [](std::uint8_t b) { return b != 0; })) return;
  std::size_t i = 0;
  const auto leaves = [&](const CityObject& object) {
    if (bad[i++] == 0) return false;
    Diagnostic diagnostic = diagnose(code, why, object.id);
    diagnostic.severity = Severity::Warning;
    diagnostics.push_back(std::move(diagnostic));
    return true;
  };
  // remove_if visits in order and each element once.
  std::erase_if(model.buildings, [&](const Building& building) { return leaves(building.object); });
  std::erase_if(model.others, leaves);
}

Vec3 originFor(const CityModel& model, const Box2& extent) {
  if (extent.empty()) return Vec3::Zero();
  const Vec2 centre = extent.center() * model.crs.unit;
  if (model.crs.kind == CrsKind::Geographic) {
    constexpr double kPerDegree = 1e5;
    return {std::floor(centre.x() * kPerDegree) / kPerDegree,
            std::floor(centre.y() * kPerDegree) / kPerDegree, 0};
  }
  const bool known = model.crs.kind == CrsKind::Projected;
  const double far = extent.max.cwiseAbs().cwiseMax(extent.min.cwiseAbs()).maxCoeff();
  if (!known && far < kNearZero) return Vec3::Zero();
  return {std::floor(centre.x()), std::floor(centre.y()), 0};
}

/// Metres on the ground in one unit of a Mercator projection at `centre`; 1 for other systems.
double mercatorScale(const Crs& crs, const Vec2& centre) {
  const auto srs = crs.kind == CrsKind::Projected ? horizontalReference(crs) : nullptr;
  const char* projection = srs ? srs->GetAttrValue("PROJECTION") : nullptr;
  if (!projection || !std::string_view(projection).starts_with("Mercator")) return 1;
  const Transformation toDegrees = toDegreesFrom(crs);
  constexpr double kStep = 100;
  Vec2 a = centre;
  Vec2 b = centre + Vec2(0, kStep);
  if (!toDegrees || !toDegrees->Transform(1, &a.x(), &a.y()) || !toDegrees->Transform(1, &b.x(), &b.y()))
    return 1;
  const Frame frame(resolveCrs("EPSG:4326"), {a.x(), a.y(), 0});
  const double scale = frame.toLocal(b).norm() / kStep;
  return std::isfinite(scale) && scale > 0 ? scale : 1;
}

/// Into another system; objects that have no place in it are left out and said.
void transformInto(CityModel& model, const Crs& target, Diagnostics& diagnostics) {
  CPLPushErrorHandler(CPLQuietErrorHandler);
  const Transformation transform = transformation(model.crs, target);
  const double vertical = model.crs.verticalUnit / target.verticalUnit;
  const std::vector<Places> all = placesOf(model);
  std::vector<std::uint8_t> bad(all.size(), 0);
  // One after the other: PROJ picks the operation for a place by the places before it.
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto map = [&](double& x, double& y) {
      if (!transform || !transform->Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y))
        bad[i] = 1;
    };
    forEachVertex(
        all[i],
        [&](Vec3& p) {
          map(p.x(), p.y());
          p.z() *= vertical;
        },
        [&](Vec2& p) { map(p.x(), p.y()); });
    if (!all[i].building) continue;
    all[i].building->base *= vertical;
    if (all[i].building->heightSource == HeightSource::Geometry) all[i].building->height *= vertical;
  }
  CPLPopErrorHandler();
  leaveOut(model, bad, Code::CrsTransformFailed, model.crs.name + " → " + target.name, diagnostics);
  model.crs = target;
}

/// Mercator's metres are 1/cos(latitude) too many: 1.6 in Berlin. Where that tells, the model becomes
/// geographic, which localise() brings to true metres.
void straightenMercator(CityModel& model, const Vec2& centre, const std::string& place,
                        Diagnostics& diagnostics) {
  constexpr double kTrueEnough = 0.01;
  const double scale = mercatorScale(model.crs, centre);
  if (std::abs(scale - 1) < kTrueEnough) return;
  diagnostics.push_back(diagnose(Code::MercatorStraightened,
                                 fmt::format("1 unit of {} is {:.3f} m there", model.crs.name, scale), {},
                                 place));
  transformInto(model, resolveCrs("EPSG:4326"), diagnostics);
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
    straightenMercator(model, centre, place, diagnostics);
  }
  CPLPopErrorHandler();
  return diagnostics;
}

Diagnostics reproject(CityModel& model, const Crs& target) {
  Diagnostics diagnostics;
  const auto usable = [](const Crs& crs) {
    return crs.kind == CrsKind::Projected || crs.kind == CrsKind::Geographic;
  };
  const bool same =
      model.crs.source == target.source || (model.crs.epsg != 0 && model.crs.epsg == target.epsg);
  if (!usable(model.crs) || !usable(target) || same) return diagnostics;
  const std::string place = model.sources.empty() ? std::string() : model.sources.front().path;
  diagnostics.push_back(diagnose(Code::CrsMixed, model.crs.name + " → " + target.name, {}, place));
  transformInto(model, target, diagnostics);
  return diagnostics;
}

Diagnostics localise(CityModel& model, const Progress& progress) {
  Diagnostics diagnostics;
  std::vector<Places> all = placesOf(model);
  const Box2 extent = unionOf(boxesOf(all), model.lines);
  model.origin = originFor(model, extent);
  const Frame frame(model);
  const double vertical = model.crs.verticalUnit;
  std::vector<std::uint8_t> bad(all.size(), 0);
  std::atomic<std::size_t> done{0};
  progress.checkpoint();
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
    if (progress.stopRequested()) return;
    const auto inPlan = [&](Vec2& p) {
      p = frame.toLocal(p);
      if (!p.allFinite()) bad[i] = 1;
    };
    const auto inSpace = [&](Vec3& p) {
      p = frame.toLocal(p);
      if (!p.allFinite()) bad[i] = 1;
    };
    forEachVertex(all[i], inSpace, inPlan);
    if (Building* building = all[i].building) {
      building->base = building->base * vertical - model.origin.z();
      if (building->heightSource == HeightSource::Geometry) building->height *= vertical;
    }
    const std::size_t count = done.fetch_add(1) + 1;
    if (count % 1024 == 0) progress.report(static_cast<double>(count) / static_cast<double>(all.size()));
  });
  progress.checkpoint();
  for (LineLayer& layer : model.lines) {
    for (auto& line : layer.lines) {
      for (Vec2& p : line) p = frame.toLocal(p);
    }
  }
  leaveOut(model, bad, Code::CoordinateBad, "a vertex of it is no place", diagnostics);
  const bool feet = model.crs.kind != CrsKind::Geographic && model.crs.unit != 1;
  if (feet || vertical != 1) {
    diagnostics.push_back(diagnose(Code::UnitsConverted, fmt::format("1 unit of {} is {} m", model.crs.name,
                                                                     feet ? model.crs.unit : vertical)));
  }
  return diagnostics;
}

}  // namespace lodestone
