#include "model/io/citygml/citygml_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <functional>

namespace lodestone::citygml {
namespace {

struct Entry {
  std::string_view local;
  Space space = Space::None;
  Kind kind = Kind::Unknown;
  std::uint8_t value = 0;
};

constexpr Entry gml(std::string_view local, Kind kind) {
  return {local, Space::Gml, kind, 0};
}
constexpr Entry gml(std::string_view local, GeometryKind geometry) {
  return {local, Space::Gml, Kind::Aggregate, static_cast<std::uint8_t>(geometry)};
}
constexpr Entry city(std::string_view local, Kind kind) {
  return {local, Space::CityGml, kind, 0};
}
constexpr Entry city(std::string_view local, ObjectType type) {
  return {local, Space::CityGml, Kind::Object, static_cast<std::uint8_t>(type)};
}
constexpr Entry city(std::string_view local, SurfaceType type) {
  return {local, Space::CityGml, Kind::Surface, static_cast<std::uint8_t>(type)};
}

constexpr Entry kEntries[] = {
    gml("MultiSurface", GeometryKind::MultiSurface),
    gml("MultiPolygon", GeometryKind::MultiSurface),
    gml("MultiGeometry", GeometryKind::MultiSurface),
    gml("OrientableSurface", GeometryKind::MultiSurface),
    gml("CompositeSurface", GeometryKind::CompositeSurface),
    gml("Shell", GeometryKind::CompositeSurface),
    gml("Surface", GeometryKind::CompositeSurface),
    gml("PolyhedralSurface", GeometryKind::CompositeSurface),
    gml("TriangulatedSurface", GeometryKind::CompositeSurface),
    gml("Tin", GeometryKind::CompositeSurface),
    gml("MultiSolid", GeometryKind::MultiSolid),
    gml("CompositeSolid", GeometryKind::CompositeSolid),
    gml("Solid", Kind::Solid),
    gml("Polygon", Kind::Polygon),
    gml("PolygonPatch", Kind::Polygon),
    gml("Triangle", Kind::Polygon),
    gml("Rectangle", Kind::Polygon),
    gml("LinearRing", Kind::Ring),
    gml("Ring", Kind::Ring),
    gml("exterior", Kind::Boundary),
    gml("interior", Kind::Boundary),
    gml("outerBoundaryIs", Kind::Boundary),
    gml("innerBoundaryIs", Kind::Boundary),
    gml("posList", Kind::PosList),
    gml("pos", Kind::Pos),
    gml("coordinates", Kind::Coordinates),
    gml("Envelope", Kind::Envelope),
    gml("MultiCurve", Kind::Curve),
    gml("MultiLineString", Kind::Curve),
    gml("LineString", Kind::Curve),
    gml("Curve", Kind::Curve),
    gml("CompositeCurve", Kind::Curve),
    gml("OrientableCurve", Kind::Curve),
    gml("GeometricComplex", Kind::Curve),
    gml("MultiPoint", Kind::Curve),
    gml("Point", Kind::Curve),
    gml("FeatureCollection", Kind::Transparent),

    {"TexturedSurface", Space::CityGml, Kind::Aggregate,
     static_cast<std::uint8_t>(GeometryKind::MultiSurface)},
    city("ImplicitGeometry", Kind::Implicit),
    city("transformationMatrix", Kind::TransformationMatrix),
    city("referencePoint", Kind::ReferencePoint),
    city("relativeGMLGeometry", Kind::RelativeGeometry),
    city("relativeGeometry", Kind::RelativeGeometry),
    city("libraryObject", Kind::LibraryObject),
    city("Appearance", Kind::Appearance),
    city("Dynamizer", Kind::Ignored),
    city("CityModel", Kind::Transparent),
    city("Version", Kind::Transparent),
    city("VersionTransition", Kind::Transparent),
    city("Transaction", Kind::Transparent),

    city("Building", ObjectType::Building),
    city("BuildingPart", ObjectType::BuildingPart),
    city("BuildingInstallation", ObjectType::BuildingInstallation),
    city("IntBuildingInstallation", ObjectType::BuildingInstallation),
    city("BuildingConstructiveElement", ObjectType::BuildingConstructiveElement),
    city("BuildingFurniture", ObjectType::BuildingFurniture),
    city("Room", ObjectType::BuildingRoom),
    city("BuildingRoom", ObjectType::BuildingRoom),
    city("Storey", ObjectType::BuildingStorey),
    city("BuildingUnit", ObjectType::BuildingUnit),
    city("Bridge", ObjectType::Bridge),
    city("BridgePart", ObjectType::BridgePart),
    city("BridgeInstallation", ObjectType::Other),
    city("IntBridgeInstallation", ObjectType::Other),
    city("BridgeConstructionElement", ObjectType::Other),
    city("BridgeConstructiveElement", ObjectType::Other),
    city("BridgeFurniture", ObjectType::Other),
    city("BridgeRoom", ObjectType::Other),
    city("Tunnel", ObjectType::Tunnel),
    city("TunnelPart", ObjectType::TunnelPart),
    city("TunnelInstallation", ObjectType::Other),
    city("IntTunnelInstallation", ObjectType::Other),
    city("TunnelConstructiveElement", ObjectType::Other),
    city("TunnelFurniture", ObjectType::Other),
    city("HollowSpace", ObjectType::Other),
    city("OtherConstruction", ObjectType::OtherConstruction),
    city("Road", ObjectType::Road),
    city("Railway", ObjectType::Railway),
    city("Square", ObjectType::TransportSquare),
    city("Track", ObjectType::Other),
    city("TransportationComplex", ObjectType::Other),
    city("Waterway", ObjectType::Waterway),
    city("Section", ObjectType::Other),
    city("Intersection", ObjectType::Other),
    city("TrafficSpace", ObjectType::Other),
    city("AuxiliaryTrafficSpace", ObjectType::Other),
    city("ClearanceSpace", ObjectType::Other),
    city("WaterBody", ObjectType::WaterBody),
    city("PlantCover", ObjectType::PlantCover),
    city("SolitaryVegetationObject", ObjectType::SolitaryVegetation),
    city("LandUse", ObjectType::LandUse),
    city("ReliefFeature", ObjectType::Relief),
    city("TINRelief", ObjectType::Relief),
    city("MassPointRelief", ObjectType::Relief),
    city("BreaklineRelief", ObjectType::Relief),
    city("RasterRelief", ObjectType::Relief),
    city("CityFurniture", ObjectType::CityFurniture),
    city("GenericCityObject", ObjectType::GenericObject),
    city("GenericOccupiedSpace", ObjectType::GenericObject),
    city("GenericUnoccupiedSpace", ObjectType::GenericObject),
    city("GenericLogicalSpace", ObjectType::GenericObject),
    city("CityObjectGroup", ObjectType::ObjectGroup),

    city("RoofSurface", SurfaceType::Roof),
    city("GroundSurface", SurfaceType::Ground),
    city("WallSurface", SurfaceType::Wall),
    city("OuterCeilingSurface", SurfaceType::OuterCeiling),
    city("OuterFloorSurface", SurfaceType::OuterFloor),
    city("ClosureSurface", SurfaceType::Closure),
    city("InteriorWallSurface", SurfaceType::InteriorWall),
    city("CeilingSurface", SurfaceType::Ceiling),
    city("FloorSurface", SurfaceType::Floor),
    city("Window", SurfaceType::Window),
    city("WindowSurface", SurfaceType::Window),
    city("Door", SurfaceType::Door),
    city("DoorSurface", SurfaceType::Door),
    city("WaterSurface", SurfaceType::Water),
    city("WaterGroundSurface", SurfaceType::WaterGround),
    city("WaterClosureSurface", SurfaceType::WaterClosure),
    city("TrafficArea", SurfaceType::TrafficArea),
    city("AuxiliaryTrafficArea", SurfaceType::AuxiliaryTrafficArea),
    city("GenericThematicSurface", SurfaceType::Generic),
    city("Marking", SurfaceType::Generic),
    city("HoleSurface", SurfaceType::Generic),
};

constexpr std::uint32_t hashOf(std::string_view text) {
  std::uint32_t hash = 2166136261U;  // FNV-1a
  for (char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

/// Open addressing over a quarter-full table: a miss, the usual case for property names, ends at once.
class EntryTable {
 public:
  constexpr EntryTable() {
    for (const Entry& entry : kEntries) {
      std::size_t slot = hashOf(entry.local) % slots_.size();
      while (slots_[slot]) slot = (slot + 1) % slots_.size();
      slots_[slot] = &entry;
    }
  }
  [[nodiscard]] const Entry* find(std::string_view local) const {
    for (std::size_t slot = hashOf(local) % slots_.size(); slots_[slot]; slot = (slot + 1) % slots_.size()) {
      if (slots_[slot]->local == local) return slots_[slot];
    }
    return nullptr;
  }

 private:
  std::array<const Entry*, 512> slots_{};
};
static_assert(std::size(kEntries) < 256);
constexpr EntryTable kTable;

constexpr std::string_view kGml = "http://www.opengis.net/gml";
constexpr std::string_view kCityGml = "http://www.opengis.net/citygml/";
constexpr std::string_view kEarlyCityGml = "http://www.citygml.org/citygml/";
constexpr std::string_view kXlink = "http://www.w3.org/1999/xlink";

}  // namespace

const NameTable::Known& NameTable::spaceOf(std::string_view name) {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    if (!name.starts_with(known_[i].uri)) continue;
    if (i > 0) std::swap(known_[i], known_[i - 1]);
    return known_[i > 0 ? i - 1 : 0];
  }
  Known added;
  added.uri = name.substr(0, name.find(kSeparator) + 1);
  const std::string_view uri = std::string_view(added.uri).substr(0, added.uri.size() - 1);
  if (uri == kGml || uri.starts_with(std::string(kGml) + "/")) {
    added.space = Space::Gml;
  } else if (uri.starts_with(kCityGml) || uri.starts_with(kEarlyCityGml)) {
    added.space = Space::CityGml;
    const bool numbered = uri.starts_with(kCityGml) && uri.size() > 3 && uri.ends_with(".0");
    if (numbered) added.version = static_cast<std::uint8_t>(uri[uri.size() - 3] - '0');
  }
  known_.push_back(std::move(added));
  return known_.back();
}

Tag NameTable::resolve(const char* name) {
  const std::string_view whole(name);
  Tag tag;
  tag.local = whole;
  const auto* separator = static_cast<const char*>(std::memchr(whole.data(), kSeparator, whole.size()));
  if (!separator) return tag;
  const Known& known = spaceOf(whole);
  tag.space = known.space;
  tag.version = known.version;
  tag.local = whole.substr(known.uri.size());
  if (tag.space == Space::Other) return tag;
  if (const Entry* entry = kTable.find(tag.local); entry && entry->space == tag.space) {
    tag.kind = entry->kind;
    tag.value = entry->value;
  }
  return tag;
}

std::string_view XmlAttributes::find(std::string_view name) const {
  for (const char** pair = pairs_; *pair; pair += 2) {
    if (name == *pair) return pair[1];
  }
  return {};
}

std::string_view XmlAttributes::gmlId() const {
  for (const char** pair = pairs_; *pair; pair += 2) {
    const std::string_view name(*pair);
    if (name.ends_with("\x01id") && name.starts_with(kGml)) return pair[1];
  }
  return {};
}

std::string_view XmlAttributes::href() const {
  for (const char** pair = pairs_; *pair; pair += 2) {
    const std::string_view name(*pair);
    if (name.ends_with("\x01href") && name.starts_with(kXlink)) return pair[1];
  }
  return {};
}

std::uint64_t idHash(std::string_view id) {
  if (id.empty()) return 0;
  const std::uint64_t hash = std::hash<std::string_view>{}(id);
  return hash == 0 ? 1 : hash;
}

std::uint64_t linkHash(std::string_view reference) {
  return idHash(reference.starts_with('#') ? reference.substr(1) : reference);
}

bool isLocalLink(std::string_view reference) {
  return reference.starts_with('#') || reference.find_first_of("#/:") == std::string_view::npos;
}

std::string_view lodOfProperty(std::string_view local) {
  const bool named =
      local.size() > 3 && local.starts_with("lod") && std::isdigit(static_cast<unsigned char>(local[3]));
  return named ? local.substr(3, 1) : std::string_view();
}

SurfaceType guessSurfaceType(std::string_view local) {
  for (const Entry& entry : kEntries) {
    if (entry.kind == Kind::Surface && local.ends_with(entry.local))
      return static_cast<SurfaceType>(entry.value);
  }
  return SurfaceType::Generic;
}

}  // namespace lodestone::citygml
