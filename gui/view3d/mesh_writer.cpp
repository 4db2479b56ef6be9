#include "gui/view3d/mesh_writer.h"

#include <algorithm>
#include <limits>

#include "algorithms/geometry/meshing.h"

namespace lodestone {

void MeshWriter::begin(NodeId node, double base) {
  node_ = node;
  base_ = base;
  firstVertex_ = vertices.size();
  firstIndex_ = indices.size();
}

void MeshWriter::end() {
  ranges.push_back(
      {static_cast<std::uint32_t>(firstIndex_), static_cast<std::uint32_t>(indices.size() - firstIndex_)});
  MeshBox box;
  if (indices.size() > firstIndex_) {
    box.min.fill(std::numeric_limits<float>::max());
    box.max.fill(std::numeric_limits<float>::lowest());
    for (std::size_t i = firstVertex_; i < vertices.size(); ++i) {
      const std::array<float, 3> p{vertices[i].x, vertices[i].y, vertices[i].z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.min[axis] = std::min(box.min[axis], p[axis]);
        box.max[axis] = std::max(box.max[axis], p[axis]);
      }
    }
  }
  boxes.push_back(box);
}

void MeshWriter::add(const Vec3& point) {
  const Vec3f p = (point - anchor_).cast<float>();
  const auto rise = static_cast<std::uint32_t>(std::clamp(point.z() - base_, 0.0, 255.0));
  vertices.push_back({p.x(), p.y(), p.z(), node_ << 8U | rise});
}

/// Two vertices for each of the ring's: even ones at the bottom, odd ones at the top.
void MeshWriter::addWalls(const Ring& ring, double base, double top) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  for (const Vec2& p : ring) {
    add(Vec3(p.x(), p.y(), base));
    add(Vec3(p.x(), p.y(), top));
  }
  if (top <= base) return;
  const auto n = static_cast<std::uint32_t>(ring.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = first + 2 * i;
    const std::uint32_t b = first + 2 * ((i + 1) % n);
    indices.insert(indices.end(), {a, b, b + 1, a, b + 1, a + 1});
  }
}

void MeshWriter::addBlock(const Polygon& polygon, double base, double height) {
  if (polygon.outer.size() < 3) return;
  const auto first = static_cast<std::uint32_t>(vertices.size());
  addWalls(polygon.outer, base, base + height);
  for (const Ring& hole : polygon.holes) addWalls(hole, base, base + height);
  for (const auto& triangle : triangulate(polygon)) {
    for (const std::uint32_t corner : triangle) indices.push_back(first + 2 * corner + 1);
  }
}

void MeshWriter::addGeometry(const Geometry& geometry) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  for (const Vec3& point : geometry.vertices) add(point);
  for (const LevelObject::Triangle& triangle : triangulate(geometry)) {
    for (const std::uint32_t corner : triangle.vertices) indices.push_back(first + corner);
  }
}

}  // namespace lodestone
