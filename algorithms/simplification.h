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
  std::vector<std::uint32_t>
      vertex;  ///< of the original, for each vertex that is left (a half-edge collapse moves none)
  std::uint32_t operations = 0;  ///< collapses and components removed whole
  std::uint32_t componentsRemoved = 0;
};

/// Half-edge collapses in the order of their cost, by `options.method` Topology or Qem, until the share
/// `rate` of the triangles is removed; the last operation may overshoot. A collapse must keep the surface a
/// manifold, turn no triangle over, and keep vertices on borders of texture charts and materials on those
/// borders. A component in which no collapse is legal is removed whole when its turn comes, at cost area ·
/// diagonal². `classes` is used by Topology alone. One thread. Cost: O(n log n). \throw Cancelled
[[nodiscard]] Simplified simplifyByCollapses(const ComponentMesh& mesh, const Classification& classes,
                                             const SimplifyOptions& options, const Progress& progress = {});

/// Any method: what is needed of the classes is found first. \throw Cancelled
[[nodiscard]] Simplified simplify(const ComponentMesh& mesh, const SimplifyOptions& options,
                                  const Progress& progress = {});

}  // namespace lodestone
