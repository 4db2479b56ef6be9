// A tree of boxes over triangles in space, for every question that one mesh asks of another.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

/// Refers to the vertices and triangles that it was made of; they must outlive it unchanged. All answers are
/// in double precision and the same on every machine. Cost: O(n log n) to build, 40 bytes a triangle.
class TriangleTree {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// Over triangles [first, first + count) of a mesh.
  TriangleTree(std::span<const Vec3> vertices, std::span<const Triangle> triangles, std::uint32_t first,
               std::uint32_t count);
  TriangleTree(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
      : TriangleTree(vertices, triangles, 0, static_cast<std::uint32_t>(triangles.size())) {}

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] const Box3& box() const { return nodes_.front().box; }

  /// Calls visit(triangle) for each triangle whose box meets `box`, in no order that means anything.
  template <class Visit>
  void forEachIn(const Box3& box, const Visit& visit) const;

  struct Closest {
    Vec3 point = Vec3::Zero();
    double squared = std::numeric_limits<double>::infinity();
    std::uint32_t triangle = 0xFFFFFFFFU;
  };
  /// Closest point of the triangles, if it is nearer than the square root of `bound`.
  [[nodiscard]] Closest closest(const Vec3& point,
                                double bound = std::numeric_limits<double>::infinity()) const;
  /// Whether the point lies inside the surface, by the parity of crossings. \pre the triangles are closed. A
  /// ray that grazes an edge is cast again in another of a fixed list of directions.
  [[nodiscard]] bool encloses(const Vec3& point) const;
  /// Distance of the two surfaces, 0 where they cross, if it is below `bound`; `bound` otherwise.
  [[nodiscard]] double distance(const TriangleTree& other,
                                double bound = std::numeric_limits<double>::infinity()) const;

 private:
  /// Children of an inner node stand at its own index + 1 and at `right`; a leaf has `count` triangles from
  /// order_[right].
  struct Node {
    Box3 box;
    std::uint32_t right = 0;
    std::uint32_t count = 0;
  };
  enum class Crossing { None, Clean, Grazing };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end, std::vector<Box3>& boxes);
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t triangle) const;
  [[nodiscard]] Crossing crossing(const Vec3& origin, const Vec3& direction, std::uint32_t triangle) const;
  /// Crossings of a ray; −1 when one of them cannot be told.
  [[nodiscard]] int crossings(const Vec3& origin, const Vec3& direction) const;
  void nearest(std::uint32_t node, const Vec3& point, Closest& best) const;
  void separation(std::uint32_t node, const TriangleTree& other, std::uint32_t otherNode,
                  double& squared) const;

  std::span<const Vec3> vertices_;
  std::span<const Triangle> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

/// Whether two closed boxes have a point in common.
[[nodiscard]] inline bool meet(const Box3& a, const Box3& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

template <class Visit>
void TriangleTree::forEachIn(const Box3& box, const Visit& visit) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, 64> stack{};
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes_[index];
    if (!meet(node.box, box)) continue;
    if (node.count == 0) {
      stack[depth++] = node.right;
      stack[depth++] = index + 1;
      continue;
    }
    for (std::uint32_t i = 0; i < node.count; ++i) visit(order_[node.right + i]);
  }
}

}  // namespace lodestone
