#include "model/io/outlines/outline_table.h"

#include <cmath>
#include <memory>

#include "model/io/outlines/attribute_columns.h"
#include "model/io/places/georeference.h"

namespace lodestone {
namespace {

using Type = OutlineColumn::Type;

/// Local metres to world coordinates, rounded so far (1e-9 degrees, 1e-6 metres or feet: 0.1 mm at most) that
/// a source's own digits come back.
class ToWorld {
 public:
  explicit ToWorld(const CityModel& city)
      : frame_(city), digits_(city.crs.kind == CrsKind::Geographic ? 1e9 : 1e6) {}

  [[nodiscard]] MultiPolygon operator()(MultiPolygon outline) const {
    for (Polygon& polygon : outline) {
      map(polygon.outer);
      for (Ring& hole : polygon.holes) map(hole);
    }
    return outline;
  }

 private:
  void map(Ring& ring) const {
    for (Vec2& p : ring) p = (frame_.toWorld(p) * digits_).array().round().matrix() / digits_;
  }
  Frame frame_;
  double digits_;
};

OutlineValue nodeValue(NodeId node) {
  return node == kNoNode ? OutlineValue() : OutlineValue(static_cast<std::int64_t>(node));
}

const Attributes& attributesOf(const CityModel& city, const LevelObject& object) {
  static const Attributes none;
  const bool single = object.role != DrawRole::Cluster && object.buildings.size() == 1;
  return single ? city.buildings[object.buildings.front()].object.attributes : none;
}

std::vector<std::string> idsOf(const CityModel& city, const LevelObject& object) {
  std::vector<std::string> ids;
  ids.reserve(object.buildings.size());
  for (const std::uint32_t building : object.buildings) ids.push_back(city.buildings[building].object.id);
  return ids;
}

}  // namespace

std::vector<OutlineTable> levelTables(const LodChain& chain, const std::vector<std::size_t>& asked) {
  const std::vector<OutlineColumn> own{{"id", Type::Text},       {"level", Type::Text},
                                       {"role", Type::Text},     {"node", Type::Integer},
                                       {"of", Type::Integer},    {"buildings", Type::Integer},
                                       {"base", Type::Real},     {"height", Type::Real},
                                       {"negative", Type::Real}, {"building_ids", Type::TextList}};
  const auto attributes = std::make_shared<const AttributeColumns>(*chain.city, own);
  std::vector<OutlineTable> tables;
  for (const std::size_t level : wantedLevels(chain, asked)) {
    OutlineTable table;
    table.name = chain.levels[level].name;
    table.rows = chain.levels[level].objectCount;
    table.columns = own;
    table.columns.insert(table.columns.end() - 1, attributes->columns().begin(), attributes->columns().end());
    table.row = [&chain, level, attributes, toWorld = ToWorld(*chain.city)](std::size_t i) {
      LevelObject object = chain.levels[level].object(i);
      OutlineRow row;
      row.values = {object.id,
                    chain.levels[level].name,
                    std::string(toString(object.role)),
                    nodeValue(object.node),
                    nodeValue(object.of),
                    static_cast<std::int64_t>(object.buildings.size()),
                    object.base,
                    object.height,
                    object.negative};
      attributes->append(attributesOf(*chain.city, object), row.values);
      row.values.emplace_back(idsOf(*chain.city, object));
      row.outline = toWorld(std::move(object.footprint));
      return row;
    };
    tables.push_back(std::move(table));
  }
  return tables;
}

OutlineTable hullTable(const CityModel& city, const ClusterTree& tree) {
  OutlineTable table;
  table.name = "hulls";
  table.rows = tree.nodes.size();
  table.multi = false;
  table.columns = {{"node", Type::Integer},  {"parent", Type::Integer}, {"size", Type::Integer},
                   {"edges", Type::Integer}, {"area", Type::Real},      {"negative", Type::Real},
                   {"height", Type::Real},   {"base", Type::Real},      {"max_top", Type::Real},
                   {"building", Type::Text}};
  table.row = [&city, &tree, toWorld = ToWorld(city)](std::size_t i) {
    const ClusterNode& node = tree.nodes[i];
    const auto id = static_cast<NodeId>(i);
    const std::int64_t parent = node.parent == kNoNode ? -1 : static_cast<std::int64_t>(node.parent);
    OutlineRow row;
    row.values = {static_cast<std::int64_t>(id),
                  parent,
                  static_cast<std::int64_t>(node.size),
                  static_cast<std::int64_t>(node.edges),
                  node.area,
                  node.negative,
                  node.height,
                  node.base,
                  node.maxTop,
                  tree.isLeaf(id) && i < city.buildings.size() ? OutlineValue(city.buildings[i].object.id)
                                                               : OutlineValue()};
    const auto hull = tree.hull(id);
    if (!hull.empty()) row.outline = toWorld({Polygon{Ring(hull.begin(), hull.end()), {}}});
    return row;
  };
  return table;
}

std::vector<std::size_t> wantedLevels(const LodChain& chain, const std::vector<std::size_t>& asked) {
  std::vector<std::size_t> levels;
  for (std::size_t i = 0; i < chain.levels.size(); ++i) {
    if (asked.empty() || std::find(asked.begin(), asked.end(), i) != asked.end()) levels.push_back(i);
  }
  return levels;
}

}  // namespace lodestone
