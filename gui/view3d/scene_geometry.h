// Everything about a city that is computed once before it is drawn. Made on any thread, shared without locks.
#pragma once

#include <memory>

#include "gui/view3d/city_mesh.h"
#include "model/city_model.h"
#include "model/cluster_tree.h"

namespace lodestone {

struct SceneGeometry {
  std::shared_ptr<const CityModel> city;
  std::shared_ptr<const ClusterTree> tree;  ///< may be null
  std::shared_ptr<const NodeMesh> buildings;
  std::shared_ptr<const NodeMesh> clusters;  ///< null without a tree
  std::shared_ptr<const NodeMesh> context;   ///< everything that is no building, as one node
  Box3 bounds;                               ///< local metres
  double groundHeight = 0;                   ///< median of the buildings' bases
  LeafOrder leaves;                          ///< of the tree; without one each building is its own place

  [[nodiscard]] std::size_t buildingCount() const { return buildings ? buildings->ranges.size() : 0; }
  [[nodiscard]] std::size_t nodeCount() const {
    return buildingCount() + (clusters ? clusters->ranges.size() : 0);
  }
  /// The mesh that has this node; null when nothing has.
  [[nodiscard]] const NodeMesh* meshOf(NodeId node) const;
};

/// What `earlier` already has of the same city is taken over. Cost: see CityScene::setCity().
[[nodiscard]] std::shared_ptr<const SceneGeometry> makeSceneGeometry(std::shared_ptr<const CityModel> city,
                                                                     std::shared_ptr<const ClusterTree> tree,
                                                                     const SceneGeometry* earlier = nullptr);

}  // namespace lodestone
