#include "algorithms/simplification/edge_collapses.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <queue>
#include <tuple>

#include "algorithms/geometry/parallel.h"
#include "algorithms/simplification/component_collapses.h"
#include "algorithms/simplification/component_contractions.h"
#include "algorithms/simplification/simplified_mesh.h"

namespace lodestone {
namespace {

constexpr std::uint32_t kStepsBetweenLooks = 256;  // at progress and cancel
/// Of what is still to be removed: what the waiting collapses up to a cost may add up to, at two triangles
/// each, for all components to go so far by themselves. Half of it because collapses make way for others.
constexpr double kAhead = 0.5;
/// Share of the triangles to remove below which going ahead is not worth its threads.
constexpr double kLeastAhead = 1.0 / 64;

class Collapser {
 public:
  Collapser(const ComponentMesh& mesh, const Classification* classes, const SimplifyOptions& options,
            const Admission& admission, const Progress& progress)
      : mesh_(mesh),
        classes_(classes),
        options_(options),
        admission_(admission),
        progress_(progress),
        target_(std::ceil(options.rate * static_cast<double>(mesh.triangles.size()) - 1e-9)) {}

  Simplified run() {
    begin();
    if (!goAhead()) begin();
    goInOrder();
    return result();
  }

 private:
  void begin() {
    const Vec3 origin = bounds(mesh_).center();
    components_.resize(mesh_.components.size());
    forPieces(0, components_.size(), 1, progress_, [&](std::size_t first, std::size_t last) {
      for (std::size_t c = first; c < last; ++c)
        components_[c] = begin(static_cast<std::uint32_t>(c), origin);
    });
    progress_.checkpoint();
    removeUnseen();
  }

  [[nodiscard]] std::unique_ptr<ComponentSteps> begin(std::uint32_t c, const Vec3& origin) const {
    const Component& component = mesh_.components[c];
    Scope scope = needsPerception(options_.method) ? scopeOf(mesh_, c, admission_) : Scope();
    if (options_.method == SimplifyMethod::Perception)
      return std::make_unique<ComponentContractions>(part(mesh_, component), options_, origin,
                                                     std::move(scope));
    return std::make_unique<ComponentCollapses>(
        part(mesh_, component), classes_ ? boundaryPlanes(mesh_, *classes_, component) : BoundaryPlanes(),
        options_, origin, std::move(scope));
  }

  /// To take away what nobody sees costs nothing to the eye.
  void removeUnseen() {
    if (!needsPerception(options_.method)) return;
    std::vector<std::pair<double, std::uint32_t>> unseen;
    for (std::uint32_t c = 0; c < admission_.removable.size(); ++c) {
      if (admission_.removable[c]) unseen.emplace_back(components_[c]->mesh().extent(), c);
    }
    std::sort(unseen.begin(), unseen.end());
    double done = 0;
    for (const auto& [extent, c] : unseen) {
      if (done + mesh_.components[c].triangleCount > target_) continue;
      done += mesh_.components[c].triangleCount;
      components_[c]->removeWhole();
    }
  }

  [[nodiscard]] double removed() const {
    return std::accumulate(
        components_.begin(), components_.end(), 0.0,
        [](double sum, const auto& component) { return sum + component->mesh().removed(); });
  }

  /// The order of all steps is by cost over all components. But as long as less than the target is removed
  /// once every component has gone all its steps up to some cost, each can go them by itself, near in memory
  /// and beside the others, and the result is the same. False when it went too far after all.
  bool goAhead() {
    if (components_.size() < 2) return true;
    for (double left = target_ - removed(); left > kLeastAhead * target_; left = target_ - removed()) {
      const double most = costToGoTo(left);
      if (most < 0) return true;
      forPieces(0, components_.size(), 1, progress_, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = first; c < last; ++c) goUpTo(*components_[c], most);
      });
      progress_.checkpoint();
      if (removed() >= target_) return false;
      progress_.report(removed() / target_);
    }
    return true;
  }

  /// The cost up to which few enough collapses wait; negative where the cheapest are too many already.
  [[nodiscard]] double costToGoTo(double left) const {
    std::vector<double> costs;
    for (const auto& component : components_) component->addCosts(costs);
    const auto few = static_cast<std::size_t>(kAhead * left / 2 / 2);
    if (costs.empty() || few == 0) return -1;
    const std::size_t nth = std::min(few, costs.size()) - 1;
    std::nth_element(costs.begin(), costs.begin() + static_cast<std::ptrdiff_t>(nth), costs.end());
    const double most = costs[nth];
    const auto count = std::count_if(costs.begin(), costs.end(), [&](double cost) { return cost <= most; });
    if (static_cast<double>(count) <= kAhead * left / 2) return most;
    double below = -1;  // many cost the same
    for (const double cost : costs) {
      if (cost < most) below = std::max(below, cost);
    }
    return below;
  }

  void goUpTo(ComponentSteps& component, double most) const {
    for (std::uint32_t steps = 1; !component.isDone() && component.next().first <= most; ++steps) {
      if (steps % kStepsBetweenLooks == 0 && progress_.stopRequested()) return;
      component.step();
    }
  }

  /// Step by step in the order of cost; of equal costs vertices come first, in their order.
  void goInOrder() {
    using Turn = std::tuple<double, std::uint64_t, std::uint32_t>;  // cost, place among equals, component
    std::priority_queue<Turn, std::vector<Turn>, std::greater<>> turns;
    const auto addTurn = [&](std::uint32_t c) {
      if (components_[c]->isDone()) return;
      const auto [cost, vertex] = components_[c]->next();
      const Component& component = mesh_.components[c];
      turns.emplace(cost,
                    vertex < component.vertexCount ? component.firstVertex + vertex
                                                   : std::uint64_t{mesh_.vertexCount()} + c,
                    c);
    };
    for (std::uint32_t c = 0; c < components_.size(); ++c) addTurn(c);
    double done = removed();
    for (std::uint32_t steps = 1; done < target_ && !turns.empty(); ++steps) {
      if (steps % kStepsBetweenLooks == 0) {
        progress_.checkpoint();
        progress_.report(done / target_);
      }
      const std::uint32_t c = std::get<2>(turns.top());
      if (wouldTakeTheLast(c, done)) return;
      turns.pop();
      const std::uint32_t before = components_[c]->mesh().removed();
      components_[c]->step();
      done += components_[c]->mesh().removed() - before;
      addTurn(c);
    }
  }

  /// Whether the next step removes all that is left of the model, which no rate below 1 asks for.
  [[nodiscard]] bool wouldTakeTheLast(std::uint32_t c, double removed) const {
    const Component& component = mesh_.components[c];
    if (components_[c]->next().second < component.vertexCount) return false;
    const double left = component.triangleCount - components_[c]->mesh().removed();
    const auto all = static_cast<double>(mesh_.triangles.size());
    return target_ < all && removed + left >= all;
  }

  [[nodiscard]] Simplified result() const {
    std::vector<Vec3> positions;
    std::vector<ComponentMesh::Triangle> triangles;
    std::vector<std::array<Vec2f, 3>> textures;
    std::vector<bool> left;
    std::uint32_t operations = 0;
    std::uint32_t heldByCharts = 0;
    for (std::size_t c = 0; c < components_.size(); ++c) {
      const Component& component = mesh_.components[c];
      const CollapsingMesh& mesh = components_[c]->mesh();
      for (std::uint32_t v = 0; v < component.vertexCount; ++v)
        positions.push_back(components_[c]->position(v));
      for (std::uint32_t t = 0; t < component.triangleCount; ++t) {
        const auto& [i, j, k] = mesh.triangles()[t];
        triangles.push_back(
            {component.firstVertex + i, component.firstVertex + j, component.firstVertex + k});
        left.push_back(mesh.isTriangleLeft(t));
      }
      textures.insert(textures.end(), mesh.textures().begin(), mesh.textures().end());
      operations += components_[c]->operations();
      heldByCharts += components_[c]->heldByCharts();
    }
    Simplified simplified = keepTriangles(mesh_, positions, triangles, textures, left);
    simplified.operations = operations;
    simplified.heldByCharts = heldByCharts;
    return simplified;
  }

  const ComponentMesh& mesh_;
  const Classification* classes_;
  const SimplifyOptions& options_;
  const Admission& admission_;
  const Progress& progress_;
  double target_;  ///< triangles to remove
  std::vector<std::unique_ptr<ComponentSteps>> components_;
};

}  // namespace

Simplified simplifyByCollapses(const ComponentMesh& mesh, const Classification& classes,
                               const SimplifyOptions& options, const Progress& progress,
                               const Admission& admission) {
  const bool topology = needsTopology(options.method);
  Simplified simplified = Collapser(mesh, topology ? &classes : nullptr, options, admission, progress).run();
  progress.report(1);
  return simplified;
}

}  // namespace lodestone
