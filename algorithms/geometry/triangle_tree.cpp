#include "algorithms/geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

#include "algorithms/geometry/triangle_distance.h"

namespace lodestone {
namespace {

constexpr std::uint32_t kLeaf = 4;

double squaredDistance(const Box3& box, const Vec3& p) {
  return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).squaredNorm();
}

double squaredDistance(const Box3& a, const Box3& b) {
  return (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0.0).squaredNorm();
}

/// Whether the ray meets the box, its faces included.
bool meets(const Box3& box, const Vec3& origin, const Vec3& inverse) {
  const Vec3 a = (box.min - origin).cwiseProduct(inverse);
  const Vec3 b = (box.max - origin).cwiseProduct(inverse);
  return a.cwiseMin(b).maxCoeff() <= a.cwiseMax(b).minCoeff() && a.cwiseMax(b).minCoeff() >= 0;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                           std::uint32_t first, std::uint32_t count)
    : vertices_(vertices), triangles_(triangles), order_(count) {
  std::iota(order_.begin(), order_.end(), first);
  if (count == 0) return;
  std::vector<Box3> boxes(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const Vec3& corner : corners(first + i)) boxes[i].add(corner);
  }
  nodes_.reserve(count);
  // boxes are looked up by triangle: shift the indices for the time of the build
  for (std::uint32_t& triangle : order_) triangle -= first;
  build(0, count, boxes);
  for (std::uint32_t& triangle : order_) triangle += first;
}

std::uint32_t TriangleTree::build(std::uint32_t begin, std::uint32_t end, std::vector<Box3>& boxes) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box3 box;
  Box3 centres;
  for (std::uint32_t i = begin; i < end; ++i) {
    box.add(boxes[order_[i]]);
    centres.add(boxes[order_[i]].center());
  }
  nodes_[index].box = box;
  if (end - begin <= kLeaf) {
    nodes_[index].right = begin;
    nodes_[index].count = end - begin;
    return index;
  }
  int axis = 0;
  centres.size().maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double ca = boxes[a].min[axis] + boxes[a].max[axis];
                     const double cb = boxes[b].min[axis] + boxes[b].max[axis];
                     return ca != cb ? ca < cb : a < b;
                   });
  build(begin, middle, boxes);
  const std::uint32_t right = build(middle, end, boxes);
  nodes_[index].right = right;
  return index;
}

std::array<Vec3, 3> TriangleTree::corners(std::uint32_t triangle) const {
  const Triangle& t = triangles_[triangle];
  return {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
}

TriangleTree::Closest TriangleTree::closest(const Vec3& point, double bound) const {
  Closest best;
  best.squared = bound;
  if (!nodes_.empty()) nearest(0, point, best);
  return best;
}

void TriangleTree::nearest(std::uint32_t index, const Vec3& point, Closest& best) const {
  const Node& node = nodes_[index];
  if (node.count > 0) {
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const std::uint32_t triangle = order_[node.right + i];
      const Vec3 candidate = closestPoint(corners(triangle), point);
      const double squared = (candidate - point).squaredNorm();
      if (squared < best.squared || (squared == best.squared && triangle < best.triangle))
        best = {candidate, squared, triangle};
    }
    return;
  }
  std::uint32_t near = index + 1;
  std::uint32_t far = node.right;
  double nearBound = squaredDistance(nodes_[near].box, point);
  double farBound = squaredDistance(nodes_[far].box, point);
  if (farBound < nearBound) {
    std::swap(near, far);
    std::swap(nearBound, farBound);
  }
  if (nearBound <= best.squared) nearest(near, point, best);
  if (farBound <= best.squared) nearest(far, point, best);
}

TriangleTree::Crossing TriangleTree::crossing(const Vec3& origin, const Vec3& direction,
                                              std::uint32_t triangle) const {
  // Signed volumes of the ray with each edge (Plücker): one sign is inside, a zero is an edge or a corner.
  const auto [a, b, c] = corners(triangle);
  const Vec3 pa = a - origin;
  const Vec3 pb = b - origin;
  const Vec3 pc = c - origin;
  const std::array<double, 3> volumes{direction.dot(pa.cross(pb)), direction.dot(pb.cross(pc)),
                                      direction.dot(pc.cross(pa))};
  const double scale = 1e-12 * (pa.norm() * pb.norm() + pb.norm() * pc.norm() + pc.norm() * pa.norm());
  const auto [least, most] = std::minmax_element(volumes.begin(), volumes.end());
  if (*least<-scale&& * most> scale) return Crossing::None;
  if (*least <= scale && *most >= -scale) {  // an edge or a corner is met, or the ray lies in the plane
    Box3 box;
    for (const Vec3& p : {a, b, c}) box.add(p);
    return meets(box, origin, direction.cwiseInverse()) ? Crossing::Grazing : Crossing::None;
  }
  const Vec3 normal = (b - a).cross(c - a);
  const double along = normal.dot(direction);
  return normal.dot(pa) / along > 0 ? Crossing::Clean : Crossing::None;
}

int TriangleTree::crossings(const Vec3& origin, const Vec3& direction) const {
  const Vec3 inverse = direction.cwiseInverse();
  std::array<std::uint32_t, 64> stack{};
  std::size_t depth = 0;
  stack[depth++] = 0;
  int count = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes_[index];
    if (!meets(node.box, origin, inverse)) continue;
    if (node.count == 0) {
      stack[depth++] = node.right;
      stack[depth++] = index + 1;
      continue;
    }
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const Crossing found = crossing(origin, direction, order_[node.right + i]);
      if (found == Crossing::Grazing) return -1;
      if (found == Crossing::Clean) ++count;
    }
  }
  return count;
}

bool TriangleTree::encloses(const Vec3& point) const {
  // No direction is parallel to an axis or a diagonal, as the edges of buildings like to be.
  static const std::array<Vec3, 8> directions{Vec3(0.4714, 0.1523, 0.8687),   Vec3(-0.2931, 0.7177, 0.6317),
                                              Vec3(0.6173, -0.5081, 0.6007),  Vec3(-0.5519, -0.3671, 0.7487),
                                              Vec3(0.8117, 0.3539, -0.4647),  Vec3(-0.1327, 0.9011, -0.4129),
                                              Vec3(0.2293, -0.6469, -0.7273), Vec3(-0.8831, 0.2087, -0.4201)};
  if (nodes_.empty() || !box().contains(point)) return false;
  for (const Vec3& direction : directions) {
    const int count = crossings(point, direction);
    if (count >= 0) return count % 2 == 1;
  }
  return false;
}

double TriangleTree::distance(const TriangleTree& other, double bound) const {
  double squared = bound * bound;
  if (!nodes_.empty() && !other.nodes_.empty()) separation(0, other, 0, squared);
  return squared < bound * bound ? std::sqrt(squared) : bound;
}

void TriangleTree::separation(std::uint32_t index, const TriangleTree& other, std::uint32_t otherIndex,
                              double& squared) const {
  const Node& a = nodes_[index];
  const Node& b = other.nodes_[otherIndex];
  if (squaredDistance(a.box, b.box) >= squared) return;
  if (a.count > 0 && b.count > 0) {
    for (std::uint32_t i = 0; i < a.count; ++i) {
      for (std::uint32_t j = 0; j < b.count; ++j) {
        squared = std::min(
            squared, squaredDistance(corners(order_[a.right + i]), other.corners(other.order_[b.right + j])));
      }
    }
    return;
  }
  // The larger box is opened, its nearer half first.
  const bool openFirst = b.count > 0 || (a.count == 0 && a.box.size().sum() > b.box.size().sum());
  const Node& opened = openFirst ? a : b;
  const auto& nodes = openFirst ? nodes_ : other.nodes_;
  const Box3& kept = openFirst ? b.box : a.box;
  std::uint32_t near = (openFirst ? index : otherIndex) + 1;
  std::uint32_t far = opened.right;
  if (squaredDistance(nodes[far].box, kept) < squaredDistance(nodes[near].box, kept)) std::swap(near, far);
  for (const std::uint32_t half : {near, far}) {
    if (openFirst)
      separation(half, other, otherIndex, squared);
    else
      separation(index, other, half, squared);
  }
}

}  // namespace lodestone
