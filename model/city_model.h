// The city model: what every reader makes and every stage works on.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/attributes.h"
#include "model/crs.h"
#include "model/geometry.h"

namespace lodestone {

/// Semantic type of a surface: CityGML's and CityJSON's boundary surfaces and openings.
enum class SurfaceType : std::uint8_t {
  Unknown,
  Roof,
  Ground,
  Wall,
  OuterCeiling,
  OuterFloor,
  Closure,
  Window,
  Door,
  InteriorWall,
  Ceiling,
  Floor,
  Water,
  WaterGround,
  WaterClosure,
  TrafficArea,
  AuxiliaryTrafficArea,
  Generic
};
[[nodiscard]] const char* toString(SurfaceType type);  ///< CityJSON's name: "RoofSurface", "Window", …
[[nodiscard]] SurfaceType surfaceTypeFrom(std::string_view name);

enum class GeometryKind : std::uint8_t {
  MultiSurface,
  CompositeSurface,
  Solid,
  MultiSolid,
  CompositeSolid,
  MultiCurve,
  MultiPoint
};

/// One surface of a Geometry. Indices refer to the city model's appearance tables; −1 is none.
struct SurfaceInfo {
  SurfaceType type = SurfaceType::Unknown;
  std::int32_t material = -1;
  std::int32_t texture = -1;
};

/// Polygons in space, stored flat: surface s has the rings [surfaceStart[s], surfaceStart[s+1]), the first of
/// them the outer one; ring r has the vertices ringVertices[ringStart[r] … ringStart[r+1]). Rings do not
/// repeat their first vertex. For solids, shell h has the surfaces [shellStart[h], shellStart[h+1]) and solid
/// k the shells [solidStart[k], solidStart[k+1]), the first of them the outer one; both are empty for
/// surfaces.
struct Geometry {
  std::string lod;  ///< as the source writes it: "1", "2.2"; empty when it says nothing
  GeometryKind kind = GeometryKind::MultiSurface;
  std::vector<Vec3> vertices;
  std::vector<std::uint32_t> ringVertices;
  std::vector<std::uint32_t> ringStart{0};
  std::vector<std::uint32_t> surfaceStart{0};
  std::vector<SurfaceInfo> surfaces;
  std::vector<Vec2f>
      textureCoordinates;  ///< one for each of ringVertices, or none at all; NaN where a ring has none
  std::vector<std::uint32_t> shellStart;
  std::vector<std::uint32_t> solidStart;

  [[nodiscard]] std::size_t surfaceCount() const { return surfaces.size(); }
  [[nodiscard]] std::size_t ringCount() const { return ringStart.size() - 1; }
  [[nodiscard]] bool isSolid() const {
    return kind == GeometryKind::Solid || kind == GeometryKind::MultiSolid ||
           kind == GeometryKind::CompositeSolid;
  }
  /// Appends a ring of new vertices to the surface being built.
  void addRing(const std::vector<Vec3>& ring);
  /// Closes the surface being built: all rings added since the last call belong to it.
  void finishSurface(SurfaceInfo info = {});
};

/// A template geometry placed several times (CityGML ImplicitGeometry, CityJSON GeometryInstance) is expanded
/// by the readers, so that every object owns its geometry.
enum class ObjectType : std::uint8_t {
  Building,
  BuildingPart,
  BuildingInstallation,
  BuildingConstructiveElement,
  BuildingFurniture,
  BuildingRoom,
  BuildingStorey,
  BuildingUnit,
  Bridge,
  BridgePart,
  Tunnel,
  TunnelPart,
  Road,
  Railway,
  Square,
  TransportSquare,
  Waterway,
  WaterBody,
  PlantCover,
  SolitaryVegetation,
  LandUse,
  Relief,
  CityFurniture,
  GenericObject,
  ObjectGroup,
  OtherConstruction,
  Other
};
[[nodiscard]] const char* toString(
    ObjectType type);  ///< CityJSON's name: "BuildingPart", "SolitaryVegetationObject", …
[[nodiscard]] ObjectType objectTypeFrom(std::string_view name);

struct CityObject {
  std::string id;
  ObjectType type = ObjectType::Other;
  Attributes attributes;
  std::vector<Geometry> geometries;
  std::vector<CityObject> children;  ///< parts, installations, rooms, …
};

enum class HeightSource : std::uint8_t { None, Geometry, Attribute, Floors, Constant, Default };
[[nodiscard]] const char* toString(HeightSource source);  ///< "geometry", "field", "floors", …

/// A top-level building: a leaf of every clustering.
struct Building {
  CityObject object;
  MultiPolygon footprint;  ///< its parts' footprints united; empty until assigned, or when it has none
  double base = 0;         ///< z of the ground under it, metres
  double height = 0;       ///< metres above base
  HeightSource heightSource = HeightSource::None;
  std::uint32_t source = 0;  ///< index into CityModel::sources
};

struct Material {
  std::string name;
  std::array<float, 3> diffuse{0.8F, 0.8F, 0.8F};
  float transparency = 0;
  std::string json;  ///< the source's other fields as a JSON object, or empty
};

struct Texture {
  std::string path;  ///< absolute path of the image, or as given where it does not exist
  bool missing = false;
  std::string wrap;  ///< CityJSON's wrapMode: "wrap", "mirror", "clamp", "border", "none"; empty: none given
  std::string type;  ///< "specific", "typical", "unknown" or empty
  /// The bytes of the image's file where it lies inside the input's own file; `path` is a name for it then.
  std::shared_ptr<const std::string> embedded{};
};

/// Lines beside the buildings: streets, rails, rivers.
struct LineLayer {
  std::string name;
  std::vector<std::vector<Vec2>> lines;
  std::vector<std::string> kinds;  ///< of each line: OSM's highway value and the like; empty where unknown
};

struct Source {
  std::string path;
  std::string format;   ///< id of the Format that read it
  std::string version;  ///< "2.0"
  std::string title;
  std::string extensions{};  ///< CityJSON's declarations of extensions, a JSON object; empty: none
};

struct CityModel {
  std::vector<Source> sources;
  Crs crs;
  Vec3 origin = Vec3::Zero();  ///< see Crs
  std::vector<Building> buildings;
  std::vector<CityObject> others;  ///< everything that is not a building
  std::vector<LineLayer> lines;
  std::vector<Material> materials;
  std::vector<Texture> textures;
};

/// Calls `visit(object)` for the object and everything below it, parents first.
template <class Object, class Visit>
void forEachObject(Object& object, Visit&& visit) {
  visit(object);
  for (auto& child : object.children) forEachObject(child, visit);
}

/// Calls `visit(object)` for every object of the model, buildings first.
template <class Model, class Visit>
void forEachObjectOf(Model& model, Visit&& visit) {
  for (auto& building : model.buildings) forEachObject(building.object, visit);
  for (auto& object : model.others) forEachObject(object, visit);
}

/// Box around all geometry and footprints, local metres.
[[nodiscard]] Box3 bounds(const CityModel& model);
[[nodiscard]] Box3 bounds(const CityObject& object);
/// Geometry, and the block over the footprint.
[[nodiscard]] Box3 bounds(const Building& building);
/// All LoD strings present, sorted.
[[nodiscard]] std::vector<std::string> lodsOf(const CityObject& object);

}  // namespace lodestone
