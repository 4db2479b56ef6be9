// Edge collapses the slow way: lists of triangles, nothing kept between steps but the quadrics.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>

#include "algorithms/simplification/collapse_cost.h"
#include "model/component_mesh.h"

namespace lodestone::test {

/// The triangles that algorithms/simplification/edge_collapses.h leaves of an untextured mesh of manifolds,
/// and where their corners stand.
class ReferenceCollapses {
 public:
  ReferenceCollapses(const ComponentMesh& mesh, const Classification* classes, const SimplifyOptions& options)
      : mesh_(mesh),
        optimal_(options.method == SimplifyMethod::QemOptimal),
        positions_(mesh.vertices),
        cost_(mesh, classes, options),
        triangles_(mesh.triangles),
        left_(mesh.triangles.size(), true) {
    target_ = static_cast<std::size_t>(std::ceil(options.rate * mesh.triangleCount() - 1e-9));
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) renew(v);
    for (std::uint32_t c = 0; c < mesh.components.size(); ++c) offerRemovalWhereNoneWaits(c);
    while (removed() < target_ && !(queue_.empty() && removals_.empty())) step();
  }

  /// Positions of the corners of what is left.
  [[nodiscard]] std::vector<std::array<Vec3, 3>> result() const {
    std::vector<std::array<Vec3, 3>> corners;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& [a, b, c] = triangles_[t];
      if (left_[t]) corners.push_back({positions_[a], positions_[b], positions_[c]});
    }
    return corners;
  }

 private:
  struct Move {
    double cost;
    double squared;
    std::uint32_t to;
    bool operator<(const Move& other) const {
      return std::tie(cost, squared, to) < std::tie(other.cost, other.squared, other.to);
    }
  };

  [[nodiscard]] std::size_t removed() const {
    return static_cast<std::size_t>(std::count(left_.begin(), left_.end(), false));
  }
  [[nodiscard]] std::vector<std::size_t> around(std::uint32_t v) const {
    std::vector<std::size_t> result;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (left_[t] && std::count(triangles_[t].begin(), triangles_[t].end(), v) > 0) result.push_back(t);
    }
    return result;
  }
  [[nodiscard]] std::set<std::uint32_t> neighbours(std::uint32_t v) const {
    std::set<std::uint32_t> result;
    for (const std::size_t t : around(v)) result.insert(triangles_[t].begin(), triangles_[t].end());
    result.erase(v);
    return result;
  }
  [[nodiscard]] std::size_t sides(std::uint32_t a, std::uint32_t b) const {
    std::size_t count = 0;
    for (const std::size_t t : around(a))
      count += std::count(triangles_[t].begin(), triangles_[t].end(), b) > 0;
    return count;
  }
  [[nodiscard]] bool onRim(std::uint32_t v) const {
    const auto all = neighbours(v);
    return std::any_of(all.begin(), all.end(), [&](std::uint32_t n) { return sides(v, n) == 1; });
  }
  [[nodiscard]] Vec3 normal(const ComponentMesh::Triangle& t, std::uint32_t moved, const Vec3& to) const {
    const auto at = [&](std::uint32_t v) { return v == moved ? to : positions_[v]; };
    return (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
  }
  [[nodiscard]] std::set<Move> moves(std::uint32_t v) const {
    std::set<Move> result;
    const bool open = cost_.isBoundary(v) && onRim(v);
    for (const std::uint32_t to : neighbours(v)) {
      const double cost = optimal_ ? cost_.contraction(v, to).cost : cost_(v, to, open);
      if (cost < CollapseCost::kNever)
        result.insert({cost, (positions_[to] - positions_[v]).squaredNorm(), to});
    }
    return result;
  }

  [[nodiscard]] bool legal(std::uint32_t v1, std::uint32_t v2) const {
    std::set<std::uint32_t> opposite;
    const auto faces1 = around(v1);
    const Vec3 at = optimal_ ? cost_.contraction(v1, v2).at : positions_[v2];
    for (const std::uint32_t moved : {v1, v2}) {
      if (moved == v2 && !optimal_) continue;
      for (const std::size_t t : around(moved)) {
        const auto& corners = triangles_[t];
        if (std::count(corners.begin(), corners.end(), moved == v1 ? v2 : v1) > 0) {
          for (const std::uint32_t v : corners) opposite.insert(v);
          continue;
        }
        const Vec3 before = normal(corners, moved, positions_[moved]);
        const Vec3 after = normal(corners, moved, at);
        if (before == Vec3::Zero()) continue;
        if (before.dot(after) <= 1e-3 * before.norm() * after.norm() || after.norm() <= 1e-9 * before.norm())
          return false;
      }
    }
    if (!optimal_) {
      for (const std::size_t t : faces1) {
        if (std::count(triangles_[t].begin(), triangles_[t].end(), v2) > 0)
          opposite.insert(triangles_[t].begin(), triangles_[t].end());
      }
    }
    opposite.erase(v1);
    opposite.erase(v2);
    for (const std::uint32_t v : opposite) {
      if (sides(v1, v) == 1 && sides(v2, v) == 1) return false;  // an ear
    }
    for (const std::uint32_t v : neighbours(v1)) {
      if (v != v2 && opposite.count(v) == 0 && neighbours(v2).count(v) > 0) return false;
    }
    // the last triangles of a closed component fold onto each other
    if (opposite.size() < 2 && sides(v1, v2) == 2) return false;
    return sides(v1, v2) == 1 || !(onRim(v1) && onRim(v2));
  }

  void renew(std::uint32_t v) {
    const std::set<Move> all = moves(v);
    queue_.erase(v);
    if (!all.empty()) queue_[v] = all.begin()->cost;
  }

  void step() {
    const auto cheaper = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto vertex = std::min_element(queue_.begin(), queue_.end(), cheaper);
    const auto component = std::min_element(removals_.begin(), removals_.end(), cheaper);
    if (vertex == queue_.end() || (component != removals_.end() && component->second < vertex->second)) {
      const Component& last = mesh_.components[component->first];
      const auto left =
          std::count(left_.begin() + last.firstTriangle, left_.begin() + last.endTriangle(), true);
      if (target_ < left_.size() && removed() + static_cast<std::size_t>(left) == left_.size())
        return removals_.clear();  // nothing would be left, and nothing else waits
      return remove(component->first);
    }
    const std::uint32_t v = vertex->first;
    for (const Move& move : moves(v)) {
      if (!legal(v, move.to)) continue;
      if (move.cost > vertex->second)
        vertex->second = move.cost;
      else
        collapse(v, move.to);
      return;
    }
    queue_.erase(v);
    rescanWhereNoneWaits(componentOfVertex(mesh_, v));
  }

  void collapse(std::uint32_t v1, std::uint32_t v2) {
    if (optimal_) positions_[v2] = cost_.contraction(v1, v2).at;
    const Vec3 at = positions_[v2];
    for (const std::size_t t : around(v1)) {
      auto& corners = triangles_[t];
      left_[t] = std::count(corners.begin(), corners.end(), v2) == 0;
      std::replace(corners.begin(), corners.end(), v1, v2);
    }
    cost_.collapsed(v1, v2, at);
    queue_.erase(v1);
    renew(v2);
    for (const std::uint32_t v : neighbours(v2)) renew(v);
    rescanWhereNoneWaits(componentOfVertex(mesh_, v2));
  }

  [[nodiscard]] bool waits(const Component& component) const {
    const auto first = queue_.lower_bound(component.firstVertex);
    return first != queue_.end() && first->first < component.endVertex();
  }

  void rescanWhereNoneWaits(std::uint32_t c) {
    const Component& component = mesh_.components[c];
    if (waits(component)) return;
    for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v) {
      for (const Move& move : moves(v)) {
        if (!legal(v, move.to)) continue;
        queue_[v] = move.cost;
        break;
      }
    }
    offerRemovalWhereNoneWaits(c);
  }

  void offerRemovalWhereNoneWaits(std::uint32_t c) {
    const Component& component = mesh_.components[c];
    if (waits(component)) return;
    double area = 0;
    Box3 box;
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) {
      if (!left_[t]) continue;
      area += normal(triangles_[t], triangles_[t][0], positions_[triangles_[t][0]]).norm() / 2;
      for (const std::uint32_t v : triangles_[t]) box.add(positions_[v]);
    }
    bool touches = false;
    for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v)
      touches = touches || cost_.isBoundary(v);
    removals_[c] = (touches ? cost_.a() : 1) * area * box.size().squaredNorm();
  }

  void remove(std::uint32_t c) {
    const Component& component = mesh_.components[c];
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) left_[t] = false;
    removals_.erase(c);
  }

  const ComponentMesh& mesh_;
  std::size_t target_ = 0;
  bool optimal_;
  std::vector<Vec3> positions_;
  CollapseCost cost_;
  std::vector<ComponentMesh::Triangle> triangles_;
  std::vector<bool> left_;
  std::map<std::uint32_t, double> queue_;     ///< by vertex
  std::map<std::uint32_t, double> removals_;  ///< by component
};

}  // namespace lodestone::test
