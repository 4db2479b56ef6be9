// The collapses of one component, in the order of their cost.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "algorithms/simplification/admission.h"
#include "algorithms/simplification/collapse_cost.h"
#include "algorithms/simplification/component_steps.h"
#include "algorithms/simplification/vertex_queue.h"
#include "model/simplify_options.h"

namespace lodestone {

/// What the collapse v1 → v2 costs as things stand: by planes or, where it changes the look of the surface,
/// by length; with `optimal` that of the edge's contraction. `open` and `most` are CollapseCost's.
[[nodiscard]] double costOfCollapse(const CollapseCost& cost, const CollapsingMesh& mesh, bool optimal,
                                    std::uint32_t v1, std::uint32_t v2, bool open,
                                    double most = CollapseCost::kNever);

/// Vertices of one component that move onto neighbours. The planes that a boundary vertex holds on to are
/// those of the original, whatever becomes of other components.
class ComponentCollapses final : public ComponentSteps {
 public:
  /// `mesh` is one component alone.
  ComponentCollapses(const ComponentMesh& mesh, BoundaryPlanes planes, const SimplifyOptions& options,
                     const Vec3& origin, Scope scope = {});

  [[nodiscard]] bool isDone() const override { return queue_.empty(); }
  [[nodiscard]] std::pair<double, std::uint32_t> next() const override {
    return {queue_.cost(queue_.top()), queue_.top()};
  }
  void step() override;
  void removeWhole() override;
  void addCosts(std::vector<double>& costs) const override { queue_.addCosts(costs); }

  [[nodiscard]] const CollapsingMesh& mesh() const override { return mesh_; }
  [[nodiscard]] const Vec3& position(std::uint32_t v) const override { return cost_.position(v); }
  [[nodiscard]] std::uint32_t operations() const override { return operations_; }
  /// None: what changes the look costs by length here.
  [[nodiscard]] std::uint32_t heldByCharts() const override { return 0; }

 private:
  /// Moves a vertex onto a neighbour.
  struct Collapse {
    std::uint32_t v1 = 0;
    std::uint32_t v2 = 0;
    double cost = CollapseCost::kNever;
    double squared = 0;  ///< length of the edge, m²

    /// Among free moves the shortest distorts least.
    [[nodiscard]] bool before(const Collapse& other) const {
      if (cost != other.cost) return cost < other.cost;
      return squared != other.squared ? squared < other.squared : v2 < other.v2;
    }
  };

  /// What a vertex in the queue waits for.
  struct Waiting {
    Collapse collapse;
    bool cheapest = false;  ///< of all its collapses; otherwise of those that were legal when its turn came
    bool open = false;      ///< it is a boundary vertex at a rim
  };

  [[nodiscard]] bool isAtRim(std::uint32_t v) const { return cost_.isBoundary(v) && mesh_.isOpen(v); }
  [[nodiscard]] Collapse collapseOf(std::uint32_t v1, std::uint32_t v2, bool open, double most) const;
  template <class Visit>
  void forEachCollapse(std::uint32_t v, bool open, const double& most, const Visit& visit) const;
  void listCollapses(std::uint32_t v, std::vector<Collapse>& list) const;
  [[nodiscard]] bool isLegal(const Collapse& collapse);
  void renew(std::uint32_t v);
  void renewBeside(std::uint32_t v, std::uint32_t v1, std::uint32_t v2);
  void wait(std::uint32_t v, const Waiting& what);
  void tryCollapse(std::uint32_t v);
  void perform(Collapse collapse);
  void rescan();
  void offerRemoval();

  std::uint32_t vertices_;
  bool optimal_;  ///< edges contract to where the quadrics are least
  double error_;  ///< metres that a collapse may lead from its planes; 0: no bound
  Scope scope_;
  CollapseCost cost_;
  CollapsingMesh mesh_;
  VertexQueue queue_;          ///< vertices, then the component itself when only removal is left
  std::vector<Waiting> best_;  ///< by vertex in the queue
  std::uint32_t operations_ = 0;
  // kept between calls for their memory
  std::vector<Collapse> list_;
  std::vector<std::uint32_t> ring_;
  Vec3 at_ = Vec3::Zero();  ///< where the collapse that was last found legal leads
};

}  // namespace lodestone
