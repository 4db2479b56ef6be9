#include "model/io/outline_table.h"

#include <cmath>

#include "model/io/georeference.h"

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

}  // namespace

OutlineTable levelTable(const LodChain& chain, std::size_t level) {
  OutlineTable table;
  const LodLevel& source = chain.levels[level];
  table.name = source.name;
  table.rows = source.objectCount;
  table.columns = {{"id", Type::Text},       {"level", Type::Text},
                   {"role", Type::Text},     {"node", Type::Integer},
                   {"of", Type::Integer},    {"buildings", Type::Integer},
                   {"base", Type::Real},     {"height", Type::Real},
                   {"negative", Type::Real}, {"building_ids", Type::TextList}};
  table.row = [&chain, &source, toWorld = ToWorld(*chain.city)](std::size_t i) {
    LevelObject object = source.object(i);
    std::vector<std::string> ids;
    ids.reserve(object.buildings.size());
    for (const std::uint32_t building : object.buildings)
      ids.push_back(chain.city->buildings[building].object.id);
    OutlineRow row;
    row.values = {object.id,
                  source.name,
                  std::string(toString(object.role)),
                  nodeValue(object.node),
                  nodeValue(object.of),
                  static_cast<std::int64_t>(object.buildings.size()),
                  object.base,
                  object.height,
                  object.negative,
                  std::move(ids)};
    row.outline = toWorld(std::move(object.footprint));
    return row;
  };
  return table;
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
