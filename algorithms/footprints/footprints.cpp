#include "algorithms/footprints/footprints.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "algorithms/footprints/building_height.h"
#include "algorithms/geometry/predicates.h"
#include "model/lod_rank.h"

namespace lodestone {
namespace {

bool isInterior(SurfaceType type) {
  return type == SurfaceType::InteriorWall || type == SurfaceType::Ceiling || type == SurfaceType::Floor;
}

/// How well a geometry tells a footprint: the finest first, but rooms (LoD 4) and plan outlines (LoD 0) after
/// what shows the outside whole. Without a LoD it counts as LoD 2. Below 0: not at all.
double rankOf(const Geometry& geometry) {
  if (geometry.surfaceCount() == 0) return -1;
  if (geometry.kind == GeometryKind::MultiCurve || geometry.kind == GeometryKind::MultiPoint) return -1;
  return lodRank(geometry.lod, {.unsaid = 2, .interior = 1.95});
}
constexpr double kPlanRank = 1;  ///< geometries below this rank are flat outlines without a height

/// A building or one of its parts, and those of its geometries that have the finest rank.
struct Source {
  const CityObject* object = nullptr;
  double rank = -1;
  std::vector<const Geometry*> geometries;
};

Source sourceOf(const CityObject& object) {
  Source source{&object};
  for (const Geometry& geometry : object.geometries) {
    const double rank = rankOf(geometry);
    if (rank < 0 || rank < source.rank) continue;
    if (rank > source.rank) source.geometries.clear();
    source.rank = rank;
    source.geometries.push_back(&geometry);
  }
  return source;
}

void collectChildren(const CityObject& object, ObjectType type, std::vector<Source>& sources) {
  for (const CityObject& child : object.children) {
    if (child.type != type) continue;
    Source source = sourceOf(child);
    if (source.rank >= 0) sources.push_back(std::move(source));
    collectChildren(child, type, sources);
  }
}

/// The building itself and its parts, else its installations. The building's own geometry is left out where a
/// part knows better: then it is a coarse envelope of its parts.
std::vector<Source> sourcesOf(const Building& building) {
  std::vector<Source> sources;
  collectChildren(building.object, ObjectType::BuildingPart, sources);
  Source own = sourceOf(building.object);
  const bool coarser =
      std::any_of(sources.begin(), sources.end(), [&](const Source& part) { return part.rank > own.rank; });
  if (own.rank >= 0 && !coarser) sources.insert(sources.begin(), std::move(own));
  if (sources.empty()) collectChildren(building.object, ObjectType::BuildingInstallation, sources);
  return sources;
}

Ring planRing(const Geometry& geometry, std::uint32_t ring) {
  Ring plan;
  for (std::uint32_t k = geometry.ringStart[ring]; k < geometry.ringStart[ring + 1]; ++k) {
    plan.push_back(geometry.vertices[geometry.ringVertices[k]].head<2>());
  }
  return plan;
}

bool isFinite(const Ring& ring) {
  return std::all_of(ring.begin(), ring.end(), [](const Vec2& p) { return p.allFinite(); });
}

/// A surface projected down, and which way it faced.
struct PlanSurface {
  Polygon polygon;
  double signedPlanArea;  ///< positive when it faces up
  SurfaceType type;
};

/// Surfaces that cover an area when seen from above; a wall does not (1 cm² is noise of coordinates in
/// millimetres).
std::vector<PlanSurface> planSurfaces(const Source& source) {
  constexpr double kNoArea = 1e-4;
  std::vector<PlanSurface> result;
  for (const Geometry* geometry : source.geometries) {
    for (std::size_t s = 0; s < geometry->surfaceCount(); ++s) {
      if (isInterior(geometry->surfaces[s].type)) continue;
      Polygon polygon;
      for (std::uint32_t r = geometry->surfaceStart[s]; r < geometry->surfaceStart[s + 1]; ++r) {
        Ring ring = planRing(*geometry, r);
        if (ring.size() < 3 || !isFinite(ring)) continue;
        if (r == geometry->surfaceStart[s]) {
          polygon.outer = std::move(ring);
        } else {
          polygon.holes.push_back(std::move(ring));
        }
      }
      const double signedPlanArea = polygon.outer.empty() ? 0 : signedArea(polygon.outer);
      if (std::abs(signedPlanArea) < kNoArea) continue;
      result.push_back({std::move(polygon), signedPlanArea, geometry->surfaces[s].type});
    }
  }
  return result;
}

/// Surfaces whose union is the object's outline. What faces down suffices where as much faces up (a closed
/// body).
MultiPolygon outlineSurfaces(const std::vector<PlanSurface>& surfaces) {
  double up = 0;
  double down = 0;
  for (const PlanSurface& s : surfaces) (s.signedPlanArea > 0 ? up : down) += std::abs(area(s.polygon));
  const bool closed = std::abs(up - down) <= 1e-6 * (up + down);
  MultiPolygon result;
  for (const PlanSurface& s : surfaces) {
    if (!closed || s.signedPlanArea < 0) result.push_back(s.polygon);
  }
  return result;
}

struct Gathered {
  MultiPolygon polygons;
  bool outline = false;  ///< no ground surface anywhere
};

/// Ground surfaces of all sources; a part that has none gives its outline, so that it does not vanish.
Gathered gather(const std::vector<Source>& sources) {
  Gathered result{{}, true};
  for (const Source& source : sources) {
    const std::vector<PlanSurface> surfaces = planSurfaces(source);
    MultiPolygon ground;
    for (const PlanSurface& s : surfaces) {
      if (s.type == SurfaceType::Ground) ground.push_back(s.polygon);
    }
    result.outline = result.outline && ground.empty();
    if (ground.empty()) ground = outlineSurfaces(surfaces);
    result.polygons.insert(result.polygons.end(), std::make_move_iterator(ground.begin()),
                           std::make_move_iterator(ground.end()));
  }
  return result;
}

/// The outline in plan of everything that several sources hold: their convex hull.
Gathered gatherHull(const std::vector<Source>& sources) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> points;
  for (const Source& source : sources) {
    for (const Geometry* geometry : source.geometries) {
      for (const Vec3& p : geometry->vertices) {
        if (p.allFinite()) points.emplace_back(p.x(), p.y());
      }
    }
  }
  std::vector<Kernel::Point_2> hull;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  Polygon polygon;
  for (const Kernel::Point_2& p : hull) polygon.outer.emplace_back(p.x(), p.y());
  return {{std::move(polygon)}, true};
}

/// An imported mesh: hundreds of overlapping groups, whose exact union would say no more than their hull.
bool isMadeOfInstallations(const std::vector<Source>& sources) {
  return !sources.empty() && sources.front().object->type == ObjectType::BuildingInstallation;
}

void assignFootprint(Building& building, const std::vector<Source>& sources, Diagnostics& diagnostics) {
  const Gathered gathered = isMadeOfInstallations(sources) ? gatherHull(sources) : gather(sources);
  building.footprint = unite(gathered.polygons);
  if (building.footprint.empty()) {
    diagnostics.push_back(diagnose(Code::FootprintMissing, {}, building.object.id));
  } else if (gathered.outline) {
    diagnostics.push_back(diagnose(Code::FootprintFromOutline, {}, building.object.id));
  }
}

/// Repairs a footprint that came with the building.
void repairFootprint(Building& building, Diagnostics& diagnostics) {
  MultiPolygon result;
  bool valid = true;
  for (const Polygon& polygon : building.footprint) {
    const bool finite =
        isFinite(polygon.outer) && std::all_of(polygon.holes.begin(), polygon.holes.end(), isFinite);
    MultiPolygon parts = finite ? repaired(polygon) : MultiPolygon{};
    valid = valid && parts.size() == 1 && std::abs(area(parts) - area(polygon)) <= 1e-9 * area(polygon);
    result.insert(result.end(), std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
  }
  building.footprint = std::move(result);
  if (building.footprint.empty()) {
    diagnostics.push_back(diagnose(Code::FootprintMissing, "its own cannot be repaired", building.object.id));
  } else if (!valid) {
    diagnostics.push_back(diagnose(Code::FootprintRepaired, {}, building.object.id));
  }
}

/// Base and height from the lowest and highest vertex. False when there is no body to measure.
bool measure(Building& building, const std::vector<Source>& sources) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  bool body = false;
  for (const Source& source : sources) {
    body = body || source.rank >= kPlanRank;
    for (const Geometry* geometry : source.geometries) {
      for (const Vec3& p : geometry->vertices) {
        if (!p.allFinite()) continue;
        low = std::min(low, p.z());
        high = std::max(high, p.z());
      }
    }
  }
  if (high < low) return false;
  building.base = low;
  if (!body || high == low) return false;
  building.height = high - low;
  building.heightSource = HeightSource::Geometry;
  return true;
}

void assign(Building& building, const HeightRule& rule, Diagnostics& diagnostics) {
  const std::vector<Source> sources = sourcesOf(building);
  if (building.footprint.empty()) {
    assignFootprint(building, sources, diagnostics);
  } else {
    repairFootprint(building, diagnostics);
  }
  if (building.heightSource != HeightSource::None) return;
  if (!measure(building, sources)) assignHeightFromAttributes(building, rule, diagnostics);
}

}  // namespace

Diagnostics assignFootprints(CityModel& model, const ImportOptions& options, const Progress& progress) {
  const std::size_t count = model.buildings.size();
  const HeightRule rule(options);
  std::vector<Diagnostics> found(count);
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    if (progress.stopRequested()) return;
    assign(model.buildings[i], rule, found[i]);
    constexpr std::size_t kReportEvery = 256;
    if (++done % kReportEvery == 0) progress.report(static_cast<double>(done) / static_cast<double>(count));
  });
  progress.checkpoint();
  Diagnostics diagnostics;
  for (Diagnostics& some : found) {
    diagnostics.insert(diagnostics.end(), std::make_move_iterator(some.begin()),
                       std::make_move_iterator(some.end()));
  }
  return diagnostics;
}

}  // namespace lodestone
