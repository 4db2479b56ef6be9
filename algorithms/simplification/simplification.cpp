#include "algorithms/simplification/simplification.h"

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

}  // namespace lodestone
