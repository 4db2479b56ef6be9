#include "algorithms/simplification/simplification.h"

#include <cmath>

#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/edge_collapses.h"
#include "algorithms/simplification/vertex_clustering.h"

namespace lodestone {

Simplified simplify(const ComponentMesh& mesh, const Classification& classes, const SimplifyOptions& options,
                    const Progress& progress, const Admission& admission) {
  if (options.method == SimplifyMethod::VertexClustering)
    return simplifyByClustering(mesh, options.rate, progress);
  return simplifyByCollapses(mesh, classes, options, progress, admission);
}

Simplified simplify(const ComponentMesh& mesh, const SimplifyOptions& options, const Progress& progress,
                    const Admission& admission) {
  Classification classes;
  if (needsTopology(options.method)) classes = classify(mesh, options.gap, progress.part(0, 0.4));
  return simplify(mesh, classes, options, progress.part(0.4, 1, "simplify"), admission);
}

bool fallsShort(const SimplifyOptions& options, std::uint32_t before, std::uint32_t after) {
  if (options.method == SimplifyMethod::VertexClustering) return false;
  if (needsPerception(options.method) && options.rate == 1) return false;
  return before - static_cast<double>(after) < std::ceil(options.rate * before - 1e-9);
}

}  // namespace lodestone
