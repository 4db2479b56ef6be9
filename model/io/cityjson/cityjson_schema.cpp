#include "model/io/cityjson/cityjson_schema.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "model/io/cityjson/cityjson_objects.h"

namespace lodestone {
namespace {

template <std::size_t N>
bool isOneOf(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Types that the schema has and ObjectType has not, and those of extensions ("+" and a capital letter).
bool isAllowed(std::string_view type) {
  constexpr std::array<std::string_view, 8> kTypes{
      "BridgeConstructiveElement", "BridgeFurniture", "BridgeInstallation", "BridgeRoom",
      "TunnelConstructiveElement", "TunnelFurniture", "TunnelHollowSpace",  "TunnelInstallation"};
  const bool extension = type.size() > 2 && type[0] == '+' && type[1] >= 'A' && type[1] <= 'Z';
  return extension || isOneOf(type, kTypes);
}

/// Second-level objects: the schema asks for their parents.
bool needsParent(std::string_view type) {
  constexpr std::array<std::string_view, 6> kEndings{"Part",      "Installation", "ConstructiveElement",
                                                     "Furniture", "Room",         "HollowSpace"};
  if (type == "CityFurniture" || type.starts_with("+")) return false;
  if (type == "BuildingStorey" || type == "BuildingUnit") return true;
  return std::any_of(kEndings.begin(), kEndings.end(), [&](auto ending) { return type.ends_with(ending); });
}

std::string topLevelType(std::string_view type) {
  if (type == "BuildingPart") return "Building";
  if (type == "BridgePart") return "Bridge";
  if (type == "TunnelPart") return "Tunnel";
  return "GenericCityObject";
}

bool isTransport(std::string_view type) {
  constexpr std::array<std::string_view, 4> kTypes{"Road", "Railway", "TransportSquare", "Waterway"};
  return isOneOf(type, kTypes);
}

/// Types whose geometries are surfaces or single solids.
bool isPlain(std::string_view type) {
  constexpr std::array<std::string_view, 12> kTypes{
      "Bridge",         "BridgePart",   "BridgeRoom", "Building",   "BuildingPart",      "BuildingRoom",
      "BuildingStorey", "BuildingUnit", "Tunnel",     "TunnelPart", "TunnelHollowSpace", "WaterBody"};
  return isOneOf(type, kTypes);
}

}  // namespace

std::string cityJsonType(const CityObject& object, bool hasParent) {
  std::string type = toString(object.type);
  if (object.type == ObjectType::Square) type = toString(ObjectType::TransportSquare);
  if (object.type == ObjectType::Other) {
    type = object.attributes.text(kTypeAttribute).value_or("");
    if (!isAllowed(type)) type = toString(ObjectType::GenericObject);
  }
  return !hasParent && needsParent(type) ? topLevelType(type) : type;
}

GeometryFit geometryFit(std::string_view type, GeometryKind kind) {
  const bool lines = kind == GeometryKind::MultiCurve;
  const bool thin = lines || kind == GeometryKind::MultiPoint;
  const bool solid =
      kind == GeometryKind::Solid || kind == GeometryKind::MultiSolid || kind == GeometryKind::CompositeSolid;
  if (type == "TINRelief") return thin ? GeometryFit::No : GeometryFit::AsCompositeSurface;
  if (type == "LandUse" || isTransport(type)) {
    if (thin) return lines && isTransport(type) ? GeometryFit::AsIs : GeometryFit::No;
    return solid ? GeometryFit::AsMultiSurface : GeometryFit::AsIs;
  }
  if (type == "PlantCover" && thin) return GeometryFit::No;
  if (isPlain(type)) {
    if (thin) return lines && type == "WaterBody" ? GeometryFit::AsIs : GeometryFit::No;
    if (kind == GeometryKind::MultiSolid) return GeometryFit::AsCompositeSolid;
  }
  return GeometryFit::AsIs;
}

std::string cityJsonLod(const std::string& lod) {
  const bool digits = !lod.empty() && lod[0] >= '0' && lod[0] <= '3';
  if (digits && lod.size() == 1) return lod;
  if (digits && lod.size() == 3 && lod[1] == '.' && lod[2] >= '0' && lod[2] <= '3') return lod;
  if (digits) return lod.substr(0, 1);
  if (!lod.empty() && lod[0] == '4') return "3.3";  // interiors belong to LoD 3 since CityGML 3.0
  return "2";
}

bool hasAddress(std::string_view type) {
  constexpr std::array<std::string_view, 5> kTypes{"Building", "BuildingPart", "BuildingUnit", "Bridge",
                                                   "BridgePart"};
  return isOneOf(type, kTypes);
}

std::string addressList(const std::string& json) {
  using Json = nlohmann::ordered_json;
  Json list = Json::parse(json, nullptr, false);
  if (list.is_object()) list = Json::array({std::move(list)});
  const bool fits = list.is_array() && std::all_of(list.begin(), list.end(),
                                                   [](const Json& entry) { return entry.is_object(); });
  if (!fits) return {};
  for (Json& entry : list) entry.erase("location");
  return list.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string_view kindName(GeometryKind kind) {
  switch (kind) {
    case GeometryKind::MultiSurface:
      return "MultiSurface";
    case GeometryKind::CompositeSurface:
      return "CompositeSurface";
    case GeometryKind::Solid:
      return "Solid";
    case GeometryKind::MultiSolid:
      return "MultiSolid";
    case GeometryKind::CompositeSolid:
      return "CompositeSolid";
    case GeometryKind::MultiCurve:
      return "MultiLineString";
    case GeometryKind::MultiPoint:
      return "MultiPoint";
  }
  return "";
}

}  // namespace lodestone
