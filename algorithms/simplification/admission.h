// What a simplification may touch (Du, Zhu and Zhao, section 5.2; resources/docs/methods.md, 5.4).
#pragma once

#include <vector>

#include "model/component_mesh.h"
#include "model/perception.h"
#include "model/simplify_options.h"
#include "model/simplify_report.h"

namespace lodestone {

/// Where Perception and Combined may change a mesh. As it stands at first: everywhere, but no component goes.
struct Admission {
  std::vector<bool> triangles;  ///< may change their shape or go; empty: all
  std::vector<bool> removable;  ///< by component: may go whole, for nobody sees any of it; empty: none

  [[nodiscard]] bool admits(std::size_t triangle) const { return triangles.empty() || triangles[triangle]; }
  /// Whether nothing may change at all.
  [[nodiscard]] bool isEmpty() const;
};

/// By component: whether anybody sees anything of it. \pre the perception is of this mesh
[[nodiscard]] std::vector<bool> seenComponents(const ComponentMesh& mesh, const Perception& perception);

/// By `options.stage` and `options.unseen`. \pre the perception is of this mesh
[[nodiscard]] Admission admissionOf(const ComponentMesh& mesh, const Perception& perception,
                                    const SimplifyOptions& options);

/// What became of the classes. \pre `left` was made with this admission
[[nodiscard]] StageReport stageReportOf(const Perception& perception, const Admission& admission,
                                        const ComponentMesh& left);

/// The same for one component, by its own vertices.
struct Scope {
  std::vector<bool> held;  ///< stay where they are: a triangle around them is not admitted; empty: none
  bool mayGo = true;       ///< whole

  [[nodiscard]] bool holds(std::uint32_t vertex) const { return !held.empty() && held[vertex]; }
};
[[nodiscard]] Scope scopeOf(const ComponentMesh& mesh, std::uint32_t component, const Admission& admission);

}  // namespace lodestone
