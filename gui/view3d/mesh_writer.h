// Appends blocks and surfaces to a piece of a NodeMesh.
#pragma once

#include <vector>

#include "gui/view3d/city_mesh.h"

namespace lodestone {

class MeshWriter {
 public:
  explicit MeshWriter(const Vec3& anchor) : anchor_(anchor) {}

  /// What follows belongs to `node`; rises are measured from `base`.
  void begin(NodeId node, double base);
  /// Closes the node and adds its range and box.
  void end();

  /// Walls and a roof. Nobody looks from below: no floor.
  void addBlock(const Polygon& polygon, double base, double height);
  void addGeometry(const Geometry& geometry);

  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<MeshRange> ranges;
  std::vector<MeshBox> boxes;

 private:
  void add(const Vec3& point);
  void addWalls(const Ring& ring, double base, double top);

  Vec3 anchor_;
  NodeId node_ = 0;
  double base_ = 0;
  std::size_t firstVertex_ = 0;
  std::size_t firstIndex_ = 0;
};

}  // namespace lodestone
