#include "gui/view3d/scene_geometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lodestone {
namespace {

double medianBase(const CityModel& city) {
  std::vector<double> bases;
  bases.reserve(city.buildings.size());
  for (const Building& building : city.buildings) {
    if (std::isfinite(building.base)) bases.push_back(building.base);
  }
  if (bases.empty()) return 0;
  const auto middle = bases.begin() + static_cast<std::ptrdiff_t>(bases.size() / 2);
  std::nth_element(bases.begin(), middle, bases.end());
  return *middle;
}

LeafOrder identityOrder(std::size_t buildings) {
  LeafOrder order;
  order.leaves.resize(buildings);
  std::iota(order.leaves.begin(), order.leaves.end(), NodeId{0});
  order.first = order.leaves;
  order.count.assign(buildings, 1);
  return order;
}

Box3 meshBounds(const NodeMesh& mesh) {
  Box3 all;
  for (const MeshBox& box : mesh.boxes) {
    if (box.empty()) continue;
    all.add(mesh.anchor + Vec3(box.min[0], box.min[1], box.min[2]));
    all.add(mesh.anchor + Vec3(box.max[0], box.max[1], box.max[2]));
  }
  return all;
}

/// The middle of the plan on whole metres: every coordinate keeps its own last digits.
Vec3 anchorOf(const CityModel& city) {
  const Box3 box = bounds(city);
  return box.empty() ? Vec3::Zero() : Vec3(box.center().array().round());
}

}  // namespace

const NodeMesh* SceneGeometry::meshOf(NodeId node) const {
  if (buildings && buildings->has(node)) return buildings.get();
  if (clusters && clusters->has(node)) return clusters.get();
  return nullptr;
}

std::shared_ptr<const SceneGeometry> makeSceneGeometry(std::shared_ptr<const CityModel> city,
                                                       std::shared_ptr<const ClusterTree> tree,
                                                       const SceneGeometry* earlier) {
  if (!city) return nullptr;
  auto scene = std::make_shared<SceneGeometry>();
  if (earlier && earlier->city == city) {
    *scene = *earlier;
  } else {
    const Vec3 anchor = anchorOf(*city);
    scene->buildings = std::make_shared<NodeMesh>(meshBuildings(*city, anchor));
    if (!city->others.empty())
      scene->context = std::make_shared<NodeMesh>(meshContext(*city, anchor, kMaxMeshNode));
    scene->bounds = meshBounds(*scene->buildings);
    if (scene->context) scene->bounds.add(meshBounds(*scene->context));
    scene->groundHeight = medianBase(*city);
  }
  if (!tree || scene->tree != tree) {
    scene->clusters =
        tree ? std::make_shared<NodeMesh>(meshClusters(*tree, scene->buildings->anchor)) : nullptr;
    scene->leaves =
        tree && tree->dendrogram ? leafOrder(*tree->dendrogram) : identityOrder(city->buildings.size());
  }
  scene->city = std::move(city);
  scene->tree = std::move(tree);
  return scene;
}

}  // namespace lodestone
