#include "algorithms/simplification/measured_simplification.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "algorithms/geometry/parallel.h"
#include "algorithms/simplification/contacts.h"
#include "algorithms/simplification/deviation.h"
#include "algorithms/simplification/settled_simplification.h"

namespace lodestone {
namespace {

/// The paper recommends [1, 3] for simple models and [2, 8] for complex ones (section 4.2).
constexpr std::array<double, 8> kTried{1, 1.5, 2, 3, 4, 5, 6, 8};

/// Scores up to so much above the least count as equal to it: one contact that gapes, or one corner that
/// stands out, makes a score, and a little more of it is no reason to break many others.
constexpr double kTie = 0.05;

Measured measure(const ComponentMesh& mesh, const Classification& classes, const SimplifyOptions& options,
                 const Perception* perception, const Progress& progress) {
  const Progress first = progress.part(0, 0.5);
  Settled settled = perception ? simplifySettled(mesh, classes, *perception, options, first)
                               : Settled{simplify(mesh, classes, options, first), {}};
  Measured result =
      measureSimplified(mesh, classes, std::move(settled.simplified), options.a, progress.part(0.5, 1));
  result.admission = std::move(settled.admission);
  return result;
}

AutoTrial trialOf(const Measured& measured, double diagonal) {
  AutoTrial trial;
  trial.a = measured.a;
  trial.hausdorff = measured.hausdorff;
  for (const ContactReport& contact : measured.contacts) {
    trial.widestGap = std::max(trial.widestGap, contact.gap);
    trial.separated += contact.fate == ContactFate::Separated ? 1 : 0;
    trial.lost += contact.fate == ContactFate::Lost ? 1 : 0;
  }
  trial.score = diagonal > 0 ? (trial.widestGap + trial.hausdorff) / diagonal : 0;
  return trial;
}

}  // namespace

std::size_t bestTrial(std::span<const AutoTrial> trials) {
  double least = trials.front().score;
  for (const AutoTrial& trial : trials) least = std::min(least, trial.score);
  const auto rank = [&](const AutoTrial& trial) {
    return std::tuple(trial.score > (1 + kTie) * least, trial.separated + trial.lost, trial.score, trial.a);
  };
  const auto best =
      std::min_element(trials.begin(), trials.end(),
                       [&](const AutoTrial& a, const AutoTrial& b) { return rank(a) < rank(b); });
  return static_cast<std::size_t>(best - trials.begin());
}

Measured simplifyAndMeasure(const ComponentMesh& mesh, const Classification& classes,
                            const SimplifyOptions& options, const Progress& progress,
                            const Perception* perception) {
  if (!options.aAuto || !needsTopology(options.method))
    return measure(mesh, classes, options, perception, progress);
  std::array<Measured, kTried.size()> results;
  const Progress silent({}, progress.stopToken());
  forPiecesReported(kTried.size(), 1, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      SimplifyOptions one = options;
      one.a = kTried[i];
      try {
        results[i] = measure(mesh, classes, one, perception, silent);
      } catch (const Cancelled&) {  // stays in this thread: said at the checkpoint below
      }
    }
  });
  progress.checkpoint();
  const double diagonal = bounds(mesh).size().norm();
  std::vector<AutoTrial> trials;
  for (const Measured& result : results) trials.push_back(trialOf(result, diagonal));
  const std::size_t best = bestTrial(trials);
  trials[best].groups = 1;
  Measured result = std::move(results[best]);
  result.trials = std::move(trials);
  return result;
}

Measured measureSimplified(const ComponentMesh& mesh, const Classification& classes, Simplified simplified,
                           double a, const Progress& progress) {
  Measured result;
  result.simplified = std::move(simplified);
  result.contacts = followContacts(mesh, classes, result.simplified, progress.part(0, 0.6));
  result.hausdorff = hausdorffDistance(mesh, result.simplified.mesh, 0, progress.part(0.6, 1));
  result.a = a;
  return result;
}

SimplifyReport reportOf(const ComponentMesh& mesh, const Classification& classes, const Measured& measured) {
  SimplifyReport report;
  const ComponentMesh& left = measured.simplified.mesh;
  report.trianglesBefore = mesh.triangleCount();
  report.trianglesAfter = left.triangleCount();
  report.verticesBefore = mesh.vertexCount();
  report.verticesAfter = left.vertexCount();
  report.componentsBefore = static_cast<std::uint32_t>(mesh.components.size());
  report.componentsAfter = static_cast<std::uint32_t>(left.components.size());
  for (const VertexClass vertexClass : classes.vertices) {
    report.boundaryVertices += vertexClass == VertexClass::Boundary ? 1 : 0;
    report.holeVertices += vertexClass == VertexClass::Hole ? 1 : 0;
  }
  report.contacts = measured.contacts;
  report.hausdorff = measured.hausdorff;
  report.a = measured.a;
  report.trials = measured.trials;
  return report;
}

}  // namespace lodestone
