#include "model/io/footprints/deckgl_buildings.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lodestone {
namespace {

using Json = nlohmann::ordered_json;

bool isPoint(const Json& value) {
  return value.is_array() && value.size() >= 2 && value[0].is_number() && value[1].is_number();
}

Ring ringFrom(const Json& points) {
  Ring ring;
  for (const Json& point : points) {
    if (isPoint(point)) ring.emplace_back(point[0].get<double>(), point[1].get<double>());
  }
  return ring;
}

// One ring of points, or a list of rings.
Polygon polygonFrom(const Json& value) {
  Polygon polygon;
  if (!value.is_array() || value.empty()) return polygon;
  if (isPoint(value[0])) {
    polygon.outer = ringFrom(value);
    return polygon;
  }
  polygon.outer = ringFrom(value[0]);
  for (std::size_t i = 1; i < value.size(); ++i) polygon.holes.push_back(ringFrom(value[i]));
  return polygon;
}

AttributeValue attributeFrom(const Json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  return JsonText{value.dump()};
}

}  // namespace

bool looksLikeDeckGl(std::string_view head) {
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || head[first] != '[') return false;
  return head.find("\"polygon\"") != std::string_view::npos;
}

Result<std::vector<Building>> parseDeckGl(std::string_view text) {
  bool tooDeep = false;
  const auto shallow = [&tooDeep](int depth, Json::parse_event_t, Json&) {
    constexpr int kDeepest = 64;  // what follows recurses
    tooDeep = tooDeep || depth > kDeepest;
    return depth <= kDeepest;
  };
  const Json json = Json::parse(text, shallow, false);
  if (tooDeep) return diagnose(Code::NestingTooDeep);
  if (!json.is_array()) return diagnose(Code::FileMalformed, "not a JSON array");
  std::vector<Building> buildings;
  std::size_t index = 0;
  for (const Json& entry : json) {
    const std::size_t place = index++;
    if (!entry.is_object() || !entry.contains("polygon")) continue;
    Building building;
    building.object.type = ObjectType::Building;
    for (const auto& [name, value] : entry.items()) {
      if (name != "polygon" && !value.is_null()) building.object.attributes.set(name, attributeFrom(value));
    }
    building.object.id = building.object.attributes.text("id").value_or(fmt::format("{}", place));
    building.footprint.push_back(polygonFrom(entry["polygon"]));
    buildings.push_back(std::move(building));
  }
  return buildings;
}

}  // namespace lodestone
