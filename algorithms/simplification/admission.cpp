#include "algorithms/simplification/admission.h"

#include <algorithm>

namespace lodestone {

bool Admission::isEmpty() const {
  return !triangles.empty() && std::find(triangles.begin(), triangles.end(), true) == triangles.end();
}

std::vector<bool> seenComponents(const ComponentMesh& mesh, const Perception& perception) {
  std::vector<bool> seen;
  for (const Component& component : mesh.components) {
    bool any = false;
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle() && !any; ++t)
      any = perception.isSeen(t);
    seen.push_back(any);
  }
  return seen;
}

Admission admissionOf(const ComponentMesh& mesh, const Perception& perception,
                      const SimplifyOptions& options) {
  Admission admission{admittedTriangles(perception, options.stage, options.unseen), {}};
  for (const bool seen : seenComponents(mesh, perception))
    admission.removable.push_back(options.unseen && !seen);
  return admission;
}

StageReport stageReportOf(const Perception& perception, const Admission& admission,
                          const ComponentMesh& left) {
  StageReport report;
  const DetailCounts counts = countDetail(perception);
  report.classes = counts.seen;
  report.unseen = counts.unseen;
  for (std::size_t t = 0; t < perception.classes.size(); ++t) report.admitted += admission.admits(t) ? 1 : 0;
  report.removed = static_cast<std::uint32_t>(perception.classes.size()) - left.triangleCount();
  return report;
}

Scope scopeOf(const ComponentMesh& mesh, std::uint32_t component, const Admission& admission) {
  const Component& own = mesh.components[component];
  Scope scope;
  scope.mayGo = !admission.removable.empty() && admission.removable[component];
  if (admission.triangles.empty()) return scope;
  scope.held.assign(own.vertexCount, false);
  for (std::uint32_t t = own.firstTriangle; t < own.endTriangle(); ++t) {
    if (admission.admits(t)) continue;
    for (const std::uint32_t v : mesh.triangles[t]) scope.held[v - own.firstVertex] = true;
  }
  return scope;
}

}  // namespace lodestone
