#include "model/io/cityjson/cityjson_objects.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include <fmt/format.h>

#include "model/io/json_writing.h"

namespace lodestone {
namespace {

/// Real hierarchies are three deep; what is deeper than this is damaged or hostile.
constexpr int kDeepest = 32;
/// Attributes are found by walking them: without a bound a hostile object would take time in the square of
/// its size.
constexpr std::size_t kMostAttributes = 4096;

AttributeValue attributeFrom(const JsonElement& value) {
  using Type = simdjson::dom::element_type;
  switch (value.type()) {
    case Type::BOOL:
      return *as<bool>(value);
    case Type::INT64:
      return *as<std::int64_t>(value);
    case Type::DOUBLE:
      return *numberOf(value);
    case Type::STRING:
      return std::string(*as<std::string_view>(value));
    default:
      break;
  }
  return JsonText{simdjson::minify(value)};  // null, lists, objects, integers beyond 64 bits with sign
}

// Addresses may hold a point by its vertex index, which means nothing outside its document.
AttributeValue addressFrom(const JsonElement& value) {
  std::string text;
  JsonBeside entries{value};
  while (const auto entry = entries.next()) {
    const auto address = as<JsonObject>(*entry);
    if (!address) continue;
    std::string fields;
    for (const auto& [key, field] : *address) {
      if (key == "location") continue;
      fields += (fields.empty() ? "" : ",") + jsonQuoted(key) + ":" + std::string(simdjson::minify(field));
    }
    text += fmt::format("{}{{{}}}", text.empty() ? "" : ",", fields);
  }
  return JsonText{"[" + text + "]"};
}

bool isStructure(std::string_view key) {
  return key == "type" || key == "attributes" || key == "geometry" || key == "parents" || key == "children" ||
         key == "geographicalExtent";
}

void readAttributes(CityObject& object, const JsonObject& json, std::string_view type,
                    ObjectDiagnostics& said) {
  const auto hasRoom = [&] {
    if (object.attributes.size() < kMostAttributes) return true;
    said.add(Code::CountImplausible, "attributes");
    return false;
  };
  if (const auto attributes = memberAs<JsonObject>(json, "attributes")) {
    for (const auto& [key, value] : *attributes) {
      if (hasRoom()) object.attributes.set(key, attributeFrom(value));
    }
  }
  for (const auto& [key, value] : json) {
    if (!isStructure(key) && hasRoom() && !object.attributes.find(key))
      object.attributes.set(key, key == "address" ? addressFrom(value) : JsonText{simdjson::minify(value)});
  }
  if (object.type == ObjectType::ObjectGroup) {
    if (const auto members = member(json, "children")) {
      object.attributes.set("children", JsonText{simdjson::minify(*members)});
    }
  }
  if (object.type == ObjectType::Other) object.attributes.set(kTypeAttribute, std::string(type));
}

void readGeometries(CityObject& object, const JsonObject& json, CityJsonGeometryReader& geometries,
                    ObjectDiagnostics& said) {
  JsonBeside list(member(json, "geometry"));
  while (const auto entry = list.next()) {
    const auto geometryJson = as<JsonObject>(*entry);
    if (!geometryJson) {
      said.add(Code::GeometryUnsupported, "not an object");
      continue;
    }
    Geometry geometry = geometries.read(*geometryJson, said);
    if (!geometry.surfaces.empty()) object.geometries.push_back(std::move(geometry));
  }
}

}  // namespace

void CityJsonObjects::add(const JsonObject& cityObjects, const CityJsonContext& context,
                          const Progress& progress) {
  std::vector<JsonObject> jsons;
  std::vector<std::string_view> ids;
  for (const auto& [id, value] : cityObjects) {
    const auto json = as<JsonObject>(JsonElement(value));
    if (json && memberAs<std::string_view>(*json, "type")) {
      jsons.push_back(*json);
      ids.push_back(id);
    } else {
      diagnostics_.push_back(diagnose(Code::ObjectSkipped, "it has no type", std::string(id)));
    }
  }
  CityJsonGeometryReader geometries(context);
  std::vector<Node> nodes(jsons.size());
  for (std::size_t i = 0; i < jsons.size(); ++i) {
    nodes[i].object = readObject(uniqueId(std::string(ids[i])), jsons[i], geometries);
    progress.report(static_cast<double>(i) / static_cast<double>(jsons.size()));
    if (i % 64 == 0) progress.checkpoint();
  }
  linkParents(jsons, ids, nodes);
  measureDepths(nodes);

  // Deepest first, so that every object is complete when it moves below its parent; siblings in the order of
  // the file.
  std::vector<std::size_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return nodes[a].depth > nodes[b].depth; });
  for (const std::size_t i : order) {
    if (nodes[i].parent < 0) {
      place(std::move(nodes[i].object));
    } else {
      nodes[static_cast<std::size_t>(nodes[i].parent)].object.children.push_back(std::move(nodes[i].object));
    }
  }
}

std::string CityJsonObjects::uniqueId(std::string id) {
  if (ids_.insert(id).second) return id;
  std::string other;
  int& suffix =
      suffixes_[id];  // where the last search ended: many equal ids cost no more than different ones
  do {
    other = fmt::format("{}_{}", id, std::max(++suffix, 2));
    suffix = std::max(suffix, 2);
  } while (!ids_.insert(other).second);
  diagnostics_.push_back(diagnose(Code::DuplicateId, "now " + other, id));
  return other;
}

CityObject CityJsonObjects::readObject(std::string id, const JsonObject& json,
                                       CityJsonGeometryReader& geometries) {
  CityObject object;
  object.id = std::move(id);
  const std::string_view type = *memberAs<std::string_view>(json, "type");
  object.type = objectTypeFrom(type);
  ObjectDiagnostics said;
  readAttributes(object, json, type, said);
  readGeometries(object, json, geometries, said);
  said.flush(object.id, diagnostics_);
  return object;
}

/// Both directions are read: `parents` (1.1 and later) and `children` (all versions). Groups own nothing.
void CityJsonObjects::linkParents(const std::vector<JsonObject>& jsons,
                                  const std::vector<std::string_view>& ids, std::vector<Node>& nodes) {
  std::unordered_map<std::string_view, std::size_t> byId;
  for (std::size_t i = 0; i < ids.size(); ++i) byId.try_emplace(ids[i], i);
  const auto isGroup = [&](std::size_t i) { return nodes[i].object.type == ObjectType::ObjectGroup; };
  for (std::size_t i = 0; i < jsons.size(); ++i) {
    if (isGroup(i)) continue;
    JsonBeside children(member(jsons[i], "children"));
    while (const auto child = children.next()) {
      const auto found = byId.find(as<std::string_view>(*child).value_or(""));
      if (found == byId.end()) {
        diagnostics_.push_back(
            diagnose(Code::ObjectSkipped, "a child is not in the file", nodes[i].object.id));
      } else if (found->second != i && nodes[found->second].parent < 0) {
        nodes[found->second].parent = static_cast<std::int64_t>(i);
      }
    }
  }
  for (std::size_t i = 0; i < jsons.size(); ++i) {
    JsonBeside parents(member(jsons[i], "parents"));
    while (const auto parent = parents.next()) {
      const auto name = as<std::string_view>(*parent).value_or("");
      const auto found = byId.find(name);
      if (found == byId.end() || found->second == i) {
        diagnostics_.push_back(diagnose(Code::ParentMissing, std::string(name), nodes[i].object.id));
      } else if (nodes[i].parent < 0 && !isGroup(found->second)) {
        nodes[i].parent = static_cast<std::int64_t>(found->second);
      }
    }
  }
}

/// Depth of every node. Circles are cut, and chains that are too deep are cut into pieces.
void CityJsonObjects::measureDepths(std::vector<Node>& nodes) {
  std::vector<char> state(nodes.size(), 0);  // 0 new, 1 on the way up from the present node, 2 done
  std::vector<std::size_t> path;
  for (std::size_t start = 0; start < nodes.size(); ++start) {
    path.clear();
    for (std::size_t i = start; state[i] == 0;) {
      state[i] = 1;
      path.push_back(i);
      if (nodes[i].parent < 0) break;
      const auto up = static_cast<std::size_t>(nodes[i].parent);
      if (state[up] == 1) {
        diagnostics_.push_back(diagnose(Code::ParentMissing, "parents lead in a circle", nodes[i].object.id));
        nodes[i].parent = -1;
        break;
      }
      i = up;
    }
    for (auto i = path.rbegin(); i != path.rend(); ++i) {
      Node& node = nodes[*i];
      node.depth = node.parent < 0 ? 0 : nodes[static_cast<std::size_t>(node.parent)].depth + 1;
      if (node.depth >= kDeepest) {
        diagnostics_.push_back(diagnose(Code::NestingTooDeep, "cut there", node.object.id));
        node.parent = -1;
        node.depth = 0;
      }
      state[*i] = 2;
    }
  }
}

void CityJsonObjects::place(CityObject object) {
  // A part whose building is missing is a building of its own.
  if (object.type == ObjectType::BuildingPart) object.type = ObjectType::Building;
  if (object.type == ObjectType::Building) {
    Building building;
    building.object = std::move(object);
    model_.buildings.push_back(std::move(building));
  } else {
    model_.others.push_back(std::move(object));
  }
}

}  // namespace lodestone
