#include "algorithms/simplification.h"

#include "algorithms/classification.h"
#include "algorithms/edge_collapses.h"
#include "algorithms/vertex_clustering.h"

namespace lodestone {

Simplified simplify(const ComponentMesh& mesh, const Classification& classes, const SimplifyOptions& options,
                    const Progress& progress) {
  if (options.method == SimplifyMethod::VertexClustering)
    return simplifyByClustering(mesh, options.rate, progress);
  return simplifyByCollapses(mesh, classes, options, progress);
}

Simplified simplify(const ComponentMesh& mesh, const SimplifyOptions& options, const Progress& progress) {
  Classification classes;
  if (options.method == SimplifyMethod::Topology)
    classes = classify(mesh, options.gap, progress.part(0, 0.4));
  return simplify(mesh, classes, options, progress.part(0.4, 1, "simplify"));
}

}  // namespace lodestone
