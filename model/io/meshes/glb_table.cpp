#include "model/io/meshes/glb_table.h"

#include <algorithm>
#include <limits>
#include <set>
#include <unordered_map>

namespace lodestone {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostColumns = 64;
constexpr std::size_t kRarest = 100;  // one building in so many has the attribute
constexpr double kNoNumber = std::numeric_limits<double>::lowest();
/// Properties that every table has; attributes must not take their names.
constexpr const char* kOwnProperties[] = {"id",        "role", "node",   "of",      "level",
                                          "buildings", "base", "height", "negative"};

bool isNumber(const AttributeValue& value) {
  return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value);
}

std::string propertyId(const std::string& name, std::set<std::string>& taken) {
  std::string id;
  for (char c : name) {
    const bool allowed = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    id += allowed ? c : '_';
  }
  if (id.empty() || (id[0] >= '0' && id[0] <= '9')) id.insert(0, "_");
  std::string unique = id;
  for (int i = 2; !taken.insert(unique).second; ++i) unique = id + "_" + std::to_string(i);
  return unique;
}

template <class Value>
std::string_view bytesOf(const std::vector<Value>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

Json scalar(const char* name, const char* componentType, const char* description) {
  return {{"name", name},
          {"description", description},
          {"type", "SCALAR"},
          {"componentType", componentType},
          {"required", true}};
}

Json schemaProperties() {
  Json node = scalar("node", "UINT32", "Node of the cluster tree.");
  Json of = scalar("of", "UINT32", "Node of the cluster that a landmark stands in.");
  for (Json* property : {&node, &of}) {
    property->erase("required");
    (*property)["noData"] = kNoNode;
  }
  Json text{{"name", "id"},
            {"description", "The building's own id, or \"cluster-\" and its node."},
            {"type", "STRING"},
            {"required", true}};
  Json role{{"name", "role"},
            {"description", "What is drawn."},
            {"type", "ENUM"},
            {"enumType", "role"},
            {"required", true}};
  Json buildings{{"name", "buildings"},
                 {"description", "Ids of the source buildings that this stands for."},
                 {"type", "STRING"},
                 {"array", true},
                 {"required", true}};
  return {{"id", text},
          {"role", role},
          {"node", node},
          {"of", of},
          {"level", scalar("level", "UINT32", "Place in the chain; 0 is the original.")},
          {"buildings", buildings},
          {"base", scalar("base", "FLOAT64", "Height of the ground, metres.")},
          {"height", scalar("height", "FLOAT64", "Height above the ground, metres.")},
          {"negative", scalar("negative", "FLOAT64", "Negative space of a cluster, square metres.")}};
}

Json roleEnum() {
  Json values = Json::array();
  for (DrawRole role : {DrawRole::Cluster, DrawRole::Building, DrawRole::Landmark}) {
    values.push_back({{"name", toString(role)}, {"value", static_cast<int>(role)}});
  }
  return {{"name", "Role"}, {"valueType", "UINT8"}, {"values", std::move(values)}};
}

}  // namespace

std::vector<AttributeColumn> attributeColumns(const CityModel& city) {
  struct Use {
    std::size_t count = 0;
    std::size_t numbers = 0;
    std::size_t order = 0;
  };
  std::unordered_map<std::string, Use> uses;
  for (const Building& building : city.buildings) {
    for (const auto& [name, value] : building.object.attributes) {
      Use& use = uses.try_emplace(name, Use{0, 0, uses.size()}).first->second;
      ++use.count;
      if (isNumber(value)) ++use.numbers;
    }
  }
  std::vector<std::pair<std::string, Use>> common(uses.begin(), uses.end());
  std::erase_if(common,
                [&](const auto& entry) { return entry.second.count * kRarest < city.buildings.size(); });
  std::sort(common.begin(), common.end(), [](const auto& a, const auto& b) {
    return a.second.count != b.second.count ? a.second.count > b.second.count
                                            : a.second.order < b.second.order;
  });
  common.resize(std::min(common.size(), kMostColumns));
  std::sort(common.begin(), common.end(),
            [](const auto& a, const auto& b) { return a.second.order < b.second.order; });

  std::set<std::string> taken(std::begin(kOwnProperties), std::end(kOwnProperties));
  std::vector<AttributeColumn> columns;
  for (const auto& [name, use] : common)
    columns.push_back({name, propertyId(name, taken), use.numbers == use.count});
  return columns;
}

void GlbTable::Texts::add(std::string_view text) {
  // Texts of a broken encoding would break the file; JSON's own rules mend them.
  const bool plain =
      std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  if (plain) {
    bytes += text;
  } else {
    bytes += Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
  }
  offsets.push_back(static_cast<std::uint32_t>(bytes.size()));
}

GlbTable::GlbTable(std::shared_ptr<const CityModel> city, std::size_t level)
    : city_(std::move(city)), level_(level) {
  if (!city_) return;
  for (AttributeColumn& column : attributeColumns(*city_)) columns_.push_back({std::move(column), {}, {}});
}

void GlbTable::add(const LevelObject& object) {
  ++rows_;
  ids_.add(object.id);
  roles_.push_back(static_cast<std::uint8_t>(object.role));
  nodes_.push_back(object.node);
  of_.push_back(object.of);
  bases_.push_back(object.base);
  heights_.push_back(object.height);
  negatives_.push_back(object.negative);
  for (std::uint32_t building : object.buildings) {
    if (city_) buildings_.add(city_->buildings[building].object.id);
  }
  buildingOffsets_.push_back(static_cast<std::uint32_t>(buildings_.offsets.size() - 1));

  const bool single = city_ && object.role != DrawRole::Cluster && object.buildings.size() == 1;
  for (Column& column : columns_) {
    const AttributeValue* value =
        single ? city_->buildings[object.buildings[0]].object.attributes.find(column.attribute.name)
               : nullptr;
    if (!column.attribute.isNumber) {
      column.texts.add(value ? toText(*value) : std::string());
    } else if (value && std::holds_alternative<double>(*value)) {
      column.numbers.push_back(std::get<double>(*value));
    } else {
      column.numbers.push_back(value ? static_cast<double>(std::get<std::int64_t>(*value)) : kNoNumber);
    }
  }
}

Json GlbTable::write(const std::function<std::size_t(std::string_view)>& addView) const {
  Json properties = schemaProperties();
  Json table = Json::object();
  const auto addTexts = [&](const std::string& name, const Texts& texts) {
    table[name]["values"] = addView(texts.bytes);
    table[name]["stringOffsets"] = addView(bytesOf(texts.offsets));
  };
  const std::vector<std::uint32_t> levels(rows_, static_cast<std::uint32_t>(level_));
  addTexts("id", ids_);
  table["role"]["values"] = addView(bytesOf(roles_));
  table["node"]["values"] = addView(bytesOf(nodes_));
  table["of"]["values"] = addView(bytesOf(of_));
  table["level"]["values"] = addView(bytesOf(levels));
  addTexts("buildings", buildings_);
  table["buildings"]["arrayOffsets"] = addView(bytesOf(buildingOffsets_));
  table["base"]["values"] = addView(bytesOf(bases_));
  table["height"]["values"] = addView(bytesOf(heights_));
  table["negative"]["values"] = addView(bytesOf(negatives_));
  for (const Column& column : columns_) {
    const std::string& id = column.attribute.property;
    Json& property = properties[id];
    property["name"] = column.attribute.name;
    if (column.attribute.isNumber) {
      property.update({{"type", "SCALAR"}, {"componentType", "FLOAT64"}, {"noData", kNoNumber}});
      table[id]["values"] = addView(bytesOf(column.numbers));
    } else {
      property.update({{"type", "STRING"}, {"noData", ""}});
      addTexts(id, column.texts);
    }
  }
  return {
      {"schema",
       {{"id", "lodestone"},
        {"name", "Lodestone level"},
        {"enums", {{"role", roleEnum()}}},
        {"classes", {{"object", {{"name", "Object of a level"}, {"properties", std::move(properties)}}}}}}},
      {"propertyTables", Json::array({{{"name", "objects"},
                                       {"class", "object"},
                                       {"count", rows_},
                                       {"properties", std::move(table)}}})}};
}

}  // namespace lodestone
