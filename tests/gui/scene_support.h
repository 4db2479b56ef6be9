// Small cities and trees whose every triangle is known, and slow obvious ways to look at them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "gui/view3d/camera_ray.h"
#include "gui/view3d/city_scene.h"
#include "model/cluster_tree.h"

namespace lodestone::test {

inline Building boxBuilding(const std::string& id, double x, double y, double width, double depth,
                            double height, double base = 0) {
  Building building;
  building.object.id = id;
  building.object.type = ObjectType::Building;
  building.footprint = {
      {{Vec2(x, y), Vec2(x + width, y), Vec2(x + width, y + depth), Vec2(x, y + depth)}, {}}};
  building.base = base;
  building.height = height;
  return building;
}

/// `side` × `side` houses 30 m apart: boxes, an L every third and a courtyard every fourth; all heights
/// differ.
inline std::shared_ptr<CityModel> smallTown(int side) {
  auto city = std::make_shared<CityModel>();
  for (int i = 0; i < side * side; ++i) {
    const double x = 30.0 * (i % side);
    const double y = 30.0 * (i / side);
    Building building =
        boxBuilding("b" + std::to_string(i), x, y, 14 + i % 5, 12 + i % 7, 6 + (i * 7) % 23, 0.25 * (i % 3));
    Ring& outer = building.footprint[0].outer;
    if (i % 3 == 1)
      outer = {Vec2(x, y),         Vec2(x + 18, y),     Vec2(x + 18, y + 6),
               Vec2(x + 7, y + 6), Vec2(x + 7, y + 17), Vec2(x, y + 17)};
    if (i % 4 == 2) {
      const Vec2 low = outer[0] + Vec2(4, 4);
      building.footprint[0].outer = {Vec2(x, y), Vec2(x + 20, y), Vec2(x + 20, y + 18), Vec2(x, y + 18)};
      building.footprint[0].holes = {
          {low, low + Vec2(0, 6), low + Vec2(6, 6), low + Vec2(6, 0)}};  // clockwise
    }
    city->buildings.push_back(std::move(building));
  }
  return city;
}

/// A tree made by hand: buildings joined in their order, (0,1), (2,3), …, then these in turn; hulls are plan
/// boxes.
inline std::shared_ptr<ClusterTree> handMadeTree(const CityModel& city) {
  auto tree = std::make_shared<ClusterTree>();
  auto dendrogram = std::make_shared<Dendrogram>();
  const auto leaves = static_cast<std::uint32_t>(city.buildings.size());
  dendrogram->leafCount = leaves;
  const auto addHull = [&](ClusterNode& node) {
    node.hullBegin = tree->hullVertices.size();
    const Vec2 &low = node.box.min, &high = node.box.max;
    for (const Vec2& p : {low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())})
      tree->hullVertices.push_back(p);
    node.edges = 4;
    node.faces = {6, 12};
    node.area = (high - low).prod();
  };
  for (const Building& building : city.buildings) {
    ClusterNode node;
    node.box = bounds(building.footprint);
    node.base = node.minBase = building.base;
    node.height = building.height;
    node.maxTop = building.base + building.height;
    addHull(node);
    tree->nodes.push_back(node);
  }
  std::vector<NodeId> level(leaves);
  for (NodeId i = 0; i < leaves; ++i) level[i] = i;
  while (level.size() > 1) {
    std::vector<NodeId> next;
    for (std::size_t i = 0; i + 1 < level.size(); i += 2) {
      const auto id = static_cast<NodeId>(tree->nodes.size());
      ClusterNode node;
      node.a = level[i];
      node.b = level[i + 1];
      ClusterNode &a = tree->nodes[node.a], &b = tree->nodes[node.b];
      a.parent = b.parent = id;
      node.size = a.size + b.size;
      node.box = a.box;
      node.box.add(b.box);
      node.base = (a.base * a.size + b.base * b.size) / node.size;
      node.height = (a.height * a.size + b.height * b.size) / node.size;
      node.maxTop = std::max(a.maxTop, b.maxTop);
      node.minBase = std::min(a.minBase, b.minBase);
      addHull(node);
      node.negative = node.area / 3;
      dendrogram->merges.push_back({node.a, node.b, 1, 1, 1, node.size});
      tree->nodes.push_back(node);
      next.push_back(id);
    }
    if (level.size() % 2 != 0) next.push_back(level.back());
    level = std::move(next);
  }
  tree->dendrogram = std::move(dendrogram);
  return tree;
}

/// The merges of the lowest rank that are whole, the rest as buildings, and the highest building of the first
/// cluster as a landmark.
inline Cut handMadeCut(const ClusterTree& tree) {
  Cut cut;
  const std::uint32_t leaves = tree.dendrogram->leafCount;
  std::vector<bool> covered(leaves, false);
  for (NodeId id = leaves; id < tree.nodes.size() && tree.nodes[id].size == 2; ++id) {
    if (id % 3 == 0) continue;
    cut.drawn.push_back({id, DrawRole::Cluster});
    covered[tree.nodes[id].a] = covered[tree.nodes[id].b] = true;
  }
  if (!cut.drawn.empty()) {
    const ClusterNode& first = tree.nodes[cut.drawn[0].node];
    const NodeId higher = tree.nodes[first.a].maxTop >= tree.nodes[first.b].maxTop ? first.a : first.b;
    cut.drawn.push_back({higher, DrawRole::Landmark, cut.drawn[0].node});
  }
  for (NodeId i = 0; i < leaves; ++i) {
    if (!covered[i]) cut.drawn.push_back({i, DrawRole::Building});
  }
  for (const DrawnNode& item : cut.drawn) cut.faces += tree.nodes[item.node].faces;
  return cut;
}

struct SlowHit {
  NodeId node = kNoNode;
  double distance = 0;
};

/// The first of all drawn triangles along a ray: each one's plane, then the three edges. Nothing shared with
/// the picker.
inline std::optional<SlowHit> slowPick(const CityScene& scene, const Ray& ray) {
  std::optional<SlowHit> best;
  scene.forEachTriangle([&](const std::array<Vec3, 3>& t, NodeId node) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double towards = normal.dot(ray.direction);
    if (towards == 0) return;
    const double distance = normal.dot(t[0] - ray.origin) / towards;
    if (distance < 0 || (best && distance >= best->distance)) return;
    const Vec3 point = ray.at(distance);
    for (std::size_t k = 0; k < 3; ++k) {
      if ((t[(k + 1) % 3] - t[k]).cross(point - t[k]).dot(normal) < 0) return;
    }
    best = SlowHit{node, distance};
  });
  return best;
}

}  // namespace lodestone::test
