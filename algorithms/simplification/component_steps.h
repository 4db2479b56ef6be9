// A component that is simplified step by step, in the order of cost.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "algorithms/simplification/collapsing_mesh.h"

namespace lodestone {

/// Components have nothing to do with each other: each goes its own steps, whoever goes first.
class ComponentSteps {
 public:
  ComponentSteps() = default;
  ComponentSteps(const ComponentSteps&) = delete;
  ComponentSteps& operator=(const ComponentSteps&) = delete;
  virtual ~ComponentSteps() = default;

  [[nodiscard]] virtual bool isDone() const = 0;
  /// Cost of the next step, and its vertex; one past the last stands for the removal of the whole component.
  [[nodiscard]] virtual std::pair<double, std::uint32_t> next() const = 0;
  /// Takes the next step: a collapse, the removal, or the insight that neither is to be had at that cost.
  virtual void step() = 0;
  /// Removes the whole component now; then it is done.
  virtual void removeWhole() = 0;
  /// Adds the costs of all that waits; each is about two triangles.
  virtual void addCosts(std::vector<double>& costs) const = 0;

  [[nodiscard]] virtual const CollapsingMesh& mesh() const = 0;
  [[nodiscard]] virtual const Vec3& position(std::uint32_t v) const = 0;
  [[nodiscard]] virtual std::uint32_t operations() const = 0;
  /// Steps that shape allowed and that were left out for the sake of textures and materials, as things stand.
  [[nodiscard]] virtual std::uint32_t heldByCharts() const = 0;
};

}  // namespace lodestone
