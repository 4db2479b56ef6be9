#include "model/exterior.h"

#include <algorithm>
#include <set>

#include "model/lod_rank.h"

namespace lodestone {
namespace {

/// Where nothing is said there may be no more than a block.
double rankOf(const Geometry& geometry) {
  return lodRank(geometry.lod, {.unsaid = 1});
}

bool isDrawable(const Geometry& geometry) {
  return geometry.kind != GeometryKind::MultiCurve && geometry.kind != GeometryKind::MultiPoint &&
         geometry.surfaceCount() > 0 && rankOf(geometry) >= 1;
}

bool isInterior(ObjectType type) {
  return type == ObjectType::BuildingRoom || type == ObjectType::BuildingFurniture ||
         type == ObjectType::BuildingStorey || type == ObjectType::BuildingUnit;
}

/// Geometries that draw an object and its finest LoD; 0 where there is nothing to draw.
struct Finest {
  struct Item {
    const CityObject* object = nullptr;
    const Geometry* geometry = nullptr;
  };
  std::vector<Item> geometries;
  double rank = 0;

  void add(Finest other) {
    geometries.insert(geometries.end(), other.geometries.begin(), other.geometries.end());
    rank = std::max(rank, other.rank);
  }
};

constexpr double kAnyRank = std::numeric_limits<double>::infinity();

Finest finestOwn(const CityObject& object, double highest) {
  Finest finest;
  for (const Geometry& geometry : object.geometries) {
    const double rank = rankOf(geometry);
    if (isDrawable(geometry) && rank <= highest) finest.rank = std::max(finest.rank, rank);
  }
  bool solid = false;
  for (const Geometry& geometry : object.geometries) {
    if (!isDrawable(geometry) || rankOf(geometry) != finest.rank) continue;
    finest.geometries.push_back({&object, &geometry});
    solid = solid || geometry.isSolid();
  }
  if (solid)
    std::erase_if(finest.geometries, [](const Finest::Item& item) { return !item.geometry->isSolid(); });
  return finest;
}

Finest finestOf(const CityObject& object, double highest = kAnyRank) {
  Finest own = finestOwn(object, highest);
  Finest parts;
  Finest attached;
  for (const CityObject& child : object.children) {
    if (isInterior(child.type)) continue;
    (child.type == ObjectType::BuildingPart ? parts : attached).add(finestOf(child, highest));
  }
  if (parts.rank > own.rank) own = {};
  own.add(std::move(parts));
  own.add(std::move(attached));
  return own;
}

Geometry withoutInterior(const Geometry& geometry) {
  const auto interior = [](const SurfaceInfo& surface) { return isInterior(surface.type); };
  if (std::none_of(geometry.surfaces.begin(), geometry.surfaces.end(), interior)) return geometry;
  Geometry result;
  result.lod = geometry.lod;
  result.vertices = geometry.vertices;
  for (std::size_t s = 0; s < geometry.surfaceCount(); ++s) {
    if (interior(geometry.surfaces[s])) continue;
    for (std::uint32_t r = geometry.surfaceStart[s]; r < geometry.surfaceStart[s + 1]; ++r) {
      for (std::uint32_t i = geometry.ringStart[r]; i < geometry.ringStart[r + 1]; ++i) {
        result.ringVertices.push_back(geometry.ringVertices[i]);
        if (!geometry.textureCoordinates.empty()) {
          result.textureCoordinates.push_back(geometry.textureCoordinates[i]);
        }
      }
      result.ringStart.push_back(static_cast<std::uint32_t>(result.ringVertices.size()));
    }
    result.finishSurface(geometry.surfaces[s]);
  }
  return result;
}

}  // namespace

std::vector<ExteriorObject> exteriorObjects(const CityObject& building) {
  std::vector<ExteriorObject> result;
  for (const auto& [object, geometry] : finestOf(building).geometries) {
    Geometry exterior = withoutInterior(*geometry);
    if (exterior.surfaceCount() == 0) continue;
    if (result.empty() || result.back().object != object) result.push_back({object, {}});
    result.back().geometries.push_back(std::move(exterior));
  }
  return result;
}

std::vector<Geometry> exteriorGeometry(const CityObject& building) {
  std::vector<Geometry> result;
  for (ExteriorObject& object : exteriorObjects(building))
    std::move(object.geometries.begin(), object.geometries.end(), std::back_inserter(result));
  return result;
}

bool isInterior(SurfaceType type) {
  return type == SurfaceType::InteriorWall || type == SurfaceType::Ceiling || type == SurfaceType::Floor;
}

FaceCount facesOf(const Building& building, double finest) {
  FaceCount count;
  for (const auto& [object, geometry] : finestOf(building.object, finest).geometries)
    count += facesOf(*geometry);
  return count.triangles > 0 || building.height <= 0 ? count : facesOfBlock(building.footprint);
}

std::vector<double> exteriorRanks(const CityObject& building) {
  std::set<double> ranks;
  const auto collect = [&](const auto& self, const CityObject& object) -> void {
    for (const Geometry& geometry : object.geometries) {
      if (isDrawable(geometry)) ranks.insert(rankOf(geometry));
    }
    for (const CityObject& child : object.children) {
      if (!isInterior(child.type)) self(self, child);
    }
  };
  collect(collect, building);
  return {ranks.begin(), ranks.end()};
}

}  // namespace lodestone
