#include "algorithms/simplification/settled_admission.h"

#include <algorithm>

#include "algorithms/perception/viewpoints.h"
#include "algorithms/rendering/model_rendering.h"
#include "algorithms/simplification/simplification.h"

namespace lodestone {
namespace {

constexpr int kMostRounds = 8;

/// Triangles of the original that nobody saw, and that are in sight of `eyes` in what was made of it.
std::vector<std::uint32_t> broughtToLight(const Simplified& level, const Perception& perception,
                                          const std::vector<Vec3>& eyes, const Progress& progress) {
  std::vector<bool> hidden(level.triangle.size());
  for (std::size_t t = 0; t < hidden.size(); ++t) hidden[t] = !perception.isSeen(level.triangle[t]);
  const std::vector<bool> visible = ModelRenderer(level.mesh, nullptr).visibleFrom(eyes, hidden, progress);
  std::vector<std::uint32_t> found;
  for (std::size_t t = 0; t < visible.size(); ++t) {
    if (visible[t]) found.push_back(level.triangle[t]);
  }
  return found;
}

}  // namespace

Admission settledAdmission(const ComponentMesh& mesh, const Classification& classes,
                           const Perception& perception, const SimplifyOptions& options,
                           const Progress& progress) {
  Admission admission = admissionOf(mesh, perception, options);
  if (!options.unseen) return admission;
  const std::vector<Vec3> eyes = closerViewpoints(bounds(mesh), perception.options);
  for (int round = 0; round < kMostRounds; ++round) {
    const Progress own = progress.part(round / double{kMostRounds}, (round + 1) / double{kMostRounds});
    const Simplified level = simplify(mesh, classes, options, own.part(0, 0.5), admission);
    bool settled = true;
    for (const std::uint32_t t : broughtToLight(level, perception, eyes, own.part(0.5, 1))) {
      if (!admission.triangles[t]) continue;
      admission.triangles[t] = false;
      settled = false;
    }
    if (settled) break;
  }
  progress.report(1);
  return admission;
}

}  // namespace lodestone
