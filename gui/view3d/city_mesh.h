// The city as plain arrays: what the GPU draws and what the picker tests.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/city_model.h"
#include "model/cluster_tree.h"

namespace lodestone {

/// One vertex: place relative to the mesh's anchor, and (node << 8 | metres above the node's base, 0–255).
struct MeshVertex {
  float x, y, z;
  std::uint32_t tag;
};
inline constexpr std::uint32_t kMaxMeshNode = (1U << 24U) - 2;  ///< a tag's 24 bits, less the background

/// Indices [first, first + count) of a NodeMesh: the triangles of one node.
struct MeshRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

struct MeshBox {
  std::array<float, 3> min{1, 1, 1};
  std::array<float, 3> max{-1, -1, -1};  ///< below min: nothing to draw
  [[nodiscard]] bool empty() const { return min[0] > max[0]; }
};

/// The blocks of consecutive nodes [firstNode, firstNode + ranges.size()).
struct NodeMesh {
  NodeId firstNode = 0;
  Vec3 anchor = Vec3::Zero();  ///< local metres; vertices are relative to it, so that floats keep millimetres
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise from outside
  std::vector<MeshRange> ranges;       ///< by node − firstNode
  std::vector<MeshBox> boxes;          ///< likewise, relative to the anchor

  [[nodiscard]] bool has(NodeId node) const { return node >= firstNode && node - firstNode < ranges.size(); }
};

/// Every building: its finest exterior geometry, else its footprint as a block. In parallel, the same for any
/// number of threads. \pre at most kMaxMeshNode buildings.
[[nodiscard]] NodeMesh meshBuildings(const CityModel& city, const Vec3& anchor);
/// Some of them: `buildings[i]` is node `firstNode` + i.
[[nodiscard]] NodeMesh meshBuildings(const CityModel& city, std::span<const std::uint32_t> buildings,
                                     NodeId firstNode, const Vec3& anchor);
/// Every non-leaf node's hull as a block. \pre at most kMaxMeshNode nodes.
[[nodiscard]] NodeMesh meshClusters(const ClusterTree& tree, const Vec3& anchor);
/// Everything that is not a building, as one node numbered `node`: bridges, water, vegetation, …
[[nodiscard]] NodeMesh meshContext(const CityModel& city, const Vec3& anchor, NodeId node);

}  // namespace lodestone
