// Simplification of a building of many components (Wang et al. 2021, section 3.3;
// resources/docs/methods.md, 2.3).
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/simplification/admission.h"
#include "model/component_mesh.h"
#include "model/progress.h"
#include "model/simplify_options.h"

namespace lodestone {

struct Simplified {
  ComponentMesh mesh;
  std::vector<std::uint32_t> component;  ///< of the original, for each component that is left; ascending
  /// Of the original, for each vertex that is left: the same, but that QemOptimal and Perception
  /// move it.
  std::vector<std::uint32_t> vertex;
  std::vector<std::uint32_t> triangle;  ///< of the original, for each triangle that is left; ascending
  std::uint32_t operations = 0;  ///< collapses and components removed whole, or vertices clustered away
  std::uint32_t componentsRemoved = 0;
  /// Contractions of Perception that shape would have allowed, left out to keep textures and materials.
  std::uint32_t heldByCharts = 0;
};

/// By any method; `classes` (algorithms/simplification/classification.h) is used by Topology and Combined
/// alone, `admission` by Perception and Combined. \throw Cancelled
[[nodiscard]] Simplified simplify(const ComponentMesh& mesh, const Classification& classes,
                                  const SimplifyOptions& options, const Progress& progress = {},
                                  const Admission& admission = {});

/// The same: what is needed of the classes is found first. \throw Cancelled
[[nodiscard]] Simplified simplify(const ComponentMesh& mesh, const SimplifyOptions& options,
                                  const Progress& progress = {}, const Admission& admission = {});

/// Fewer of a model's triangles are gone than the rate asks for. Never so of VertexClustering, which comes as
/// near as its cells let it, nor at a rate of 1 where pictures say what may be touched: that asks for all
/// that is admitted.
[[nodiscard]] bool fallsShort(const SimplifyOptions& options, std::uint32_t before, std::uint32_t after);

}  // namespace lodestone
