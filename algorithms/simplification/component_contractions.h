// The contractions of one component, in the order of what they cost to the eye (Du, Zhu and Zhao, section
// 4.2; resources/docs/methods.md, 5.4).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/simplification/admission.h"
#include "algorithms/simplification/component_steps.h"
#include "algorithms/simplification/perceptual_cost.h"
#include "algorithms/simplification/vertex_queue.h"

namespace lodestone {

/// Where an edge may contract to, the best by QEM first: with both ends free CollapseCost's places, with one
/// held that end, with both nowhere.
[[nodiscard]] CollapseCost::Placements placesToContract(const CollapseCost& cost, const Scope& scope,
                                                        std::uint32_t v1, std::uint32_t v2);

/// Each step contracts the edge that costs least of all that may. An edge whose best place is not allowed, by
/// its shape or by textures, goes to its next best one, at no less than the cost of the former. Where an
/// error is set, an edge no longer than that goes to one of its ends whatever the textures, at the cost of
/// QEM*. Cost: O(log n) and some dozen evaluations a step.
class ComponentContractions final : public ComponentSteps {
 public:
  /// `mesh` is one component alone.
  ComponentContractions(const ComponentMesh& mesh, const SimplifyOptions& options, const Vec3& origin,
                        Scope scope);

  [[nodiscard]] bool isDone() const override { return queue_.empty(); }
  [[nodiscard]] std::pair<double, std::uint32_t> next() const override;
  void step() override;
  void removeWhole() override;
  void addCosts(std::vector<double>& costs) const override { queue_.addCosts(costs); }

  [[nodiscard]] const CollapsingMesh& mesh() const override { return mesh_; }
  [[nodiscard]] const Vec3& position(std::uint32_t v) const override { return cost_.position(v); }
  [[nodiscard]] std::uint32_t operations() const override { return operations_; }
  [[nodiscard]] std::uint32_t heldByCharts() const override;

 private:
  /// A vertex that goes into another, which then stands at a place.
  struct Contraction {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    Vec3 at = Vec3::Zero();
  };
  /// Places of an edge that the error allows, in the order in which they are tried.
  struct Ways {
    std::array<CollapseCost::Placement, 6> places;
    std::size_t count = 0;
    std::size_t overCharts = 0;  ///< the first that textures may be drawn out for
  };
  /// An edge in the queue, or out of it for now.
  struct Waiting {
    CollapseCost::Placement best;  ///< cost: kNever where both ends are held
    std::uint8_t place = 0;        ///< that its cost is of
    bool heldByCharts = false;     ///< an earlier one was right for the shape
  };

  [[nodiscard]] Ways waysOf(std::uint32_t edge) const;
  [[nodiscard]] double priceOf(std::uint32_t edge, const CollapseCost::Placement& place) const;
  [[nodiscard]] std::optional<Contraction> allowed(std::uint32_t edge, const Vec3& at, bool overCharts);
  void place(std::uint32_t edge);
  void price(std::uint32_t edge);
  void renewAround(std::uint32_t v, bool moved);
  void perform(const Contraction& contraction);
  void offerRemoval();

  std::uint32_t vertices_;
  double error_;  ///< metres that a contraction may lead from its planes, or a texture astray; 0: no bound
  Scope scope_;
  CollapseCost cost_;
  CollapsingMesh mesh_;
  PerceptualCost look_;
  std::uint32_t edges_;
  VertexQueue queue_;                   ///< edges, then the component itself when only removal is left
  std::vector<Waiting> waiting_;        ///< by edge
  std::vector<std::uint32_t> renewed_;  ///< by edge: after which operation
  std::uint32_t operations_ = 0;
  std::vector<std::uint32_t> ring_;    // kept between calls for its memory
  std::vector<std::uint32_t> folded_;  // likewise
};

}  // namespace lodestone
