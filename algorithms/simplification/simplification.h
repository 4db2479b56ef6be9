// Simplification of a building of many components (Wang et al. 2021, section 3.3;
// resources/docs/methods.md, 2.3).
#pragma once

#include <cstdint>
#include <vector>

#include "model/component_mesh.h"
#include "model/progress.h"
#include "model/simplify_options.h"

namespace lodestone {

struct Simplified {
  ComponentMesh mesh;
  std::vector<std::uint32_t> component;  ///< of the original, for each component that is left; ascending
  /// Of the original, for each vertex that is left: the same, but that QemOptimal moves it.
  std::vector<std::uint32_t> vertex;
  std::uint32_t operations = 0;  ///< collapses and components removed whole, or vertices clustered away
  std::uint32_t componentsRemoved = 0;
};

/// By any method; `classes` (algorithms/simplification/classification.h) is used by Topology alone. \throw
/// Cancelled
[[nodiscard]] Simplified simplify(const ComponentMesh& mesh, const Classification& classes,
                                  const SimplifyOptions& options, const Progress& progress = {});

/// The same: what is needed of the classes is found first. \throw Cancelled
[[nodiscard]] Simplified simplify(const ComponentMesh& mesh, const SimplifyOptions& options,
                                  const Progress& progress = {});

}  // namespace lodestone
