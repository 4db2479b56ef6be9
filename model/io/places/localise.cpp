// reproject() and localise() of georeference.h: a whole model into another system, and into local metres.
#include <algorithm>
#include <atomic>
#include <cmath>

#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>
#include <tbb/parallel_for.h>

#include "model/io/places/georeference.h"
#include "model/io/places/model_places.h"

namespace lodestone {
namespace {

constexpr double kNearZero = 1e5;

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

}  // namespace

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
  const bool some = !model.buildings.empty();
  leaveOut(model, bad, Code::CoordinateBad, "a vertex of it is no place", diagnostics);
  if (some && model.buildings.empty())
    diagnostics.push_back(diagnose(Code::CrsTransformFailed, "no building has a place in " + model.crs.name));
  const bool feet = model.crs.kind != CrsKind::Geographic && model.crs.unit != 1;
  if (feet || vertical != 1) {
    diagnostics.push_back(diagnose(Code::UnitsConverted, fmt::format("1 unit of {} is {} m", model.crs.name,
                                                                     feet ? model.crs.unit : vertical)));
  }
  return diagnostics;
}

}  // namespace lodestone
