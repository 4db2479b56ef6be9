#include "model/city_model.h"

#include <algorithm>
#include <set>

namespace lodestone {
namespace {

template <class Enum>
struct Named {
  Enum value;
  const char* name;
};

constexpr Named<SurfaceType> kSurfaceTypes[] = {
    {SurfaceType::Unknown, ""},
    {SurfaceType::Roof, "RoofSurface"},
    {SurfaceType::Ground, "GroundSurface"},
    {SurfaceType::Wall, "WallSurface"},
    {SurfaceType::OuterCeiling, "OuterCeilingSurface"},
    {SurfaceType::OuterFloor, "OuterFloorSurface"},
    {SurfaceType::Closure, "ClosureSurface"},
    {SurfaceType::Window, "Window"},
    {SurfaceType::Door, "Door"},
    {SurfaceType::InteriorWall, "InteriorWallSurface"},
    {SurfaceType::Ceiling, "CeilingSurface"},
    {SurfaceType::Floor, "FloorSurface"},
    {SurfaceType::Water, "WaterSurface"},
    {SurfaceType::WaterGround, "WaterGroundSurface"},
    {SurfaceType::WaterClosure, "WaterClosureSurface"},
    {SurfaceType::TrafficArea, "TrafficArea"},
    {SurfaceType::AuxiliaryTrafficArea, "AuxiliaryTrafficArea"},
    {SurfaceType::Generic, "GenericSurface"},
};

constexpr Named<HeightSource> kHeightSources[] = {
    {HeightSource::None, "none"},         {HeightSource::Geometry, "geometry"},
    {HeightSource::Attribute, "field"},   {HeightSource::Floors, "floors"},
    {HeightSource::Constant, "constant"}, {HeightSource::Default, "default"},
};

constexpr Named<ObjectType> kObjectTypes[] = {
    {ObjectType::Building, "Building"},
    {ObjectType::BuildingPart, "BuildingPart"},
    {ObjectType::BuildingInstallation, "BuildingInstallation"},
    {ObjectType::BuildingConstructiveElement, "BuildingConstructiveElement"},
    {ObjectType::BuildingFurniture, "BuildingFurniture"},
    {ObjectType::BuildingRoom, "BuildingRoom"},
    {ObjectType::BuildingStorey, "BuildingStorey"},
    {ObjectType::BuildingUnit, "BuildingUnit"},
    {ObjectType::Bridge, "Bridge"},
    {ObjectType::BridgePart, "BridgePart"},
    {ObjectType::Tunnel, "Tunnel"},
    {ObjectType::TunnelPart, "TunnelPart"},
    {ObjectType::Road, "Road"},
    {ObjectType::Railway, "Railway"},
    {ObjectType::Square, "Square"},
    {ObjectType::TransportSquare, "TransportSquare"},
    {ObjectType::Waterway, "Waterway"},
    {ObjectType::WaterBody, "WaterBody"},
    {ObjectType::PlantCover, "PlantCover"},
    {ObjectType::SolitaryVegetation, "SolitaryVegetationObject"},
    {ObjectType::LandUse, "LandUse"},
    {ObjectType::Relief, "TINRelief"},
    {ObjectType::CityFurniture, "CityFurniture"},
    {ObjectType::GenericObject, "GenericCityObject"},
    {ObjectType::ObjectGroup, "CityObjectGroup"},
    {ObjectType::OtherConstruction, "OtherConstruction"},
    {ObjectType::Other, "+Other"},
};

template <class Enum, std::size_t N>
const char* nameOf(const Named<Enum> (&table)[N], Enum value) {
  for (const auto& entry : table) {
    if (entry.value == value) return entry.name;
  }
  return "";
}

template <class Enum, std::size_t N>
Enum valueOf(const Named<Enum> (&table)[N], std::string_view name, Enum otherwise) {
  for (const auto& entry : table) {
    if (name == entry.name) return entry.value;
  }
  return otherwise;
}

}  // namespace

const char* toString(SurfaceType type) {
  return nameOf(kSurfaceTypes, type);
}
SurfaceType surfaceTypeFrom(std::string_view name) {
  return valueOf(kSurfaceTypes, name, SurfaceType::Unknown);
}
const char* toString(HeightSource source) {
  return nameOf(kHeightSources, source);
}
const char* toString(ObjectType type) {
  return nameOf(kObjectTypes, type);
}
ObjectType objectTypeFrom(std::string_view name) {
  return valueOf(kObjectTypes, name, ObjectType::Other);
}

void Geometry::addRing(const std::vector<Vec3>& ring) {
  for (const Vec3& p : ring) {
    ringVertices.push_back(static_cast<std::uint32_t>(vertices.size()));
    vertices.push_back(p);
  }
  ringStart.push_back(static_cast<std::uint32_t>(ringVertices.size()));
}

void Geometry::finishSurface(SurfaceInfo info) {
  surfaceStart.push_back(static_cast<std::uint32_t>(ringCount()));
  surfaces.push_back(info);
}

Box3 bounds(const CityObject& object) {
  Box3 box;
  forEachObject(object, [&](const CityObject& o) {
    for (const Geometry& geometry : o.geometries) {
      for (const Vec3& p : geometry.vertices) box.add(p);
    }
  });
  return box;
}

Box3 bounds(const Building& building) {
  Box3 box = bounds(building.object);
  const Box2 plan = bounds(building.footprint);
  if (plan.empty()) return box;
  box.add(Vec3(plan.min.x(), plan.min.y(), building.base));
  box.add(Vec3(plan.max.x(), plan.max.y(), building.base + building.height));
  return box;
}

Box3 bounds(const CityModel& model) {
  Box3 box;
  for (const Building& building : model.buildings) box.add(bounds(building));
  for (const CityObject& object : model.others) box.add(bounds(object));
  return box;
}

std::vector<std::string> lodsOf(const CityObject& object) {
  std::set<std::string> lods;
  forEachObject(object, [&](const CityObject& o) {
    for (const Geometry& geometry : o.geometries) {
      if (!geometry.lod.empty()) lods.insert(geometry.lod);
    }
  });
  return {lods.begin(), lods.end()};
}

}  // namespace lodestone
