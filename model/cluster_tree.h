// The dendrogram with a merged hull and a height at every node: what legible LOD draws from.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/camera.h"
#include "model/dendrogram.h"
#include "model/footprint_table.h"

namespace lodestone {

/// One node's figures; hull vertices are in ClusterTree::hullVertices. Sizes in metres and square metres.
struct ClusterNode {
  NodeId parent = kNoNode;
  NodeId a = kNoNode;  ///< children; kNoNode for leaves
  NodeId b = kNoNode;
  std::uint32_t size = 1;       ///< buildings
  std::uint64_t hullBegin = 0;  ///< first hull vertex
  std::uint32_t edges = 0;      ///< vertices of the hull
  FaceCount faces;              ///< drawn when this node is drawn: a cluster's block, or a building itself
  double area = 0;              ///< of the hull
  double negative = 0;          ///< area − area of the union of the footprints below; never below 0
  double gap = 0;               ///< metres between the hulls of its children, which its own hull bridges
  double height = 0;            ///< mean building height weighted by footprint area
  double base = 0;              ///< mean ground height, weighted likewise
  double maxTop = 0;            ///< z of the highest building top below
  double minBase = 0;           ///< z of the lowest building base below
  Box2 box;                     ///< plan box of the hull
};

/// Around all that stands below a node.
[[nodiscard]] inline Box3 boxOf(const ClusterNode& node) {
  return {{node.box.min.x(), node.box.min.y(), node.minBase},
          {node.box.max.x(), node.box.max.y(), node.maxTop}};
}

struct ClusterTree {
  std::shared_ptr<const Dendrogram> dendrogram;
  std::shared_ptr<const FootprintTable> footprints;
  MergeOptions options;
  std::vector<ClusterNode> nodes;  ///< by NodeId
  std::vector<Vec2> hullVertices;  ///< rings, counter-clockwise, node after node
  FaceCount buildingFaces;         ///< of all buildings, each drawn itself

  [[nodiscard]] bool isLeaf(NodeId node) const { return nodes[node].a == kNoNode; }
  [[nodiscard]] std::span<const Vec2> hull(NodeId node) const {
    return {hullVertices.data() + nodes[node].hullBegin, nodes[node].edges};
  }
};

enum class DrawRole : std::uint8_t { Cluster, Building, Landmark };
[[nodiscard]] const char* toString(DrawRole role);

struct DrawnNode {
  NodeId node = 0;
  DrawRole role = DrawRole::Building;
  NodeId of = kNoNode;     ///< the drawn cluster that a landmark belongs to
  double boxPixels = 0;    ///< projected negative space of a cluster
  double alphaHeight = 0;  ///< height tolerance of a cluster, metres
  std::uint8_t level = 0;  ///< of the building's own levels of detail; 0 the finest
  bool operator==(const DrawnNode&) const = default;
};

/// What legible LOD draws from one camera. Drawn clusters and buildings together with culled nodes are a cut
/// of the tree: every building has exactly one drawn or culled ancestor-or-self. Landmarks come on top.
struct Cut {
  CutOptions options;
  Camera camera;
  std::vector<DrawnNode> drawn;
  std::vector<NodeId> culled;
  FaceCount faces;  ///< of all that is drawn

  void draw(const ClusterTree& tree, const DrawnNode& node) {
    drawn.push_back(node);
    faces += tree.nodes[node.node].faces;
  }
};

}  // namespace lodestone
