// Edge collapses the slow way: nothing is kept between steps but the quadrics.
#pragma once

#include <cmath>
#include <map>
#include <tuple>

#include "algorithms/simplification/collapse_cost.h"
#include "tests/support/slow_mesh.h"

namespace lodestone::test {

/// The triangles that algorithms/simplification/edge_collapses.h leaves of an untextured mesh of manifolds,
/// and where their corners stand.
class ReferenceCollapses : public SlowMesh {
 public:
  ReferenceCollapses(const ComponentMesh& mesh, const Classification* classes, const SimplifyOptions& options)
      : SlowMesh(mesh),
        optimal_(options.method == SimplifyMethod::QemOptimal),
        cost_(mesh, classes, options) {
    target_ = static_cast<std::size_t>(std::ceil(options.rate * mesh.triangleCount() - 1e-9));
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) renew(v);
    for (std::uint32_t c = 0; c < mesh.components.size(); ++c) offerRemovalWhereNoneWaits(c);
    while (removed() < target_ && !(queue_.empty() && removals_.empty())) step();
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

  [[nodiscard]] Vec3 placeOf(std::uint32_t v1, std::uint32_t v2) const {
    return optimal_ ? cost_.contraction(v1, v2).at : positions_[v2];
  }
  [[nodiscard]] bool mayGo(std::uint32_t v1, std::uint32_t v2) const {
    return legal(v1, v2, placeOf(v1, v2));
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
      if (!mayGo(v, move.to)) continue;
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
    const Vec3 at = placeOf(v1, v2);
    join(v1, v2, at);
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
        if (!mayGo(v, move.to)) continue;
        queue_[v] = move.cost;
        break;
      }
    }
    offerRemovalWhereNoneWaits(c);
  }

  void offerRemovalWhereNoneWaits(std::uint32_t c) {
    const Component& component = mesh_.components[c];
    if (waits(component)) return;
    bool touches = false;
    for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v)
      touches = touches || cost_.isBoundary(v);
    removals_[c] = (touches ? cost_.a() : 1) * extent(component);
  }

  void remove(std::uint32_t c) {
    const Component& component = mesh_.components[c];
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) left_[t] = false;
    removals_.erase(c);
  }

  std::size_t target_ = 0;
  bool optimal_;
  CollapseCost cost_;
  std::map<std::uint32_t, double> queue_;     ///< by vertex
  std::map<std::uint32_t, double> removals_;  ///< by component
};

}  // namespace lodestone::test
