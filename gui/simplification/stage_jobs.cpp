#include "gui/simplification/stage_jobs.h"

#include <chrono>

#include "algorithms/geometry/components.h"
#include "algorithms/simplification/city_simplification.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/measured_simplification.h"
#include "algorithms/simplification/settled_simplification.h"
#include "gui/simplification/surface_images.h"

namespace lodestone {
namespace {

std::vector<ComponentCounts> countsOf(const ComponentMesh& mesh, const Classification& classes) {
  std::vector<ComponentCounts> counts(mesh.components.size());
  for (std::size_t c = 0; c < counts.size(); ++c) {
    const Component& component = mesh.components[c];
    for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v)
      ++counts[c].vertices[static_cast<std::size_t>(classes.vertices[v])];
  }
  return counts;
}

}  // namespace

Result<StagedBuilding> stageBuilding(std::shared_ptr<const CityModel> city, NodeId building,
                                     bool withTouching, double gap, const Progress& progress) {
  StagedBuilding staged;
  Diagnostics diagnostics;
  staged.buildings = {building};
  if (withTouching)
    staged.buildings = touchingGroup(*city, building, 0.01, progress.part(0, 0.2, "touching buildings"));
  staged.mesh =
      std::make_shared<const ComponentMesh>(makeComponentMesh(*city, staged.buildings, &diagnostics));
  progress.checkpoint();
  staged.surfaces = readSurfaceLook(*city, *staged.mesh, progress.part(0.2, 0.3, "textures"));
  staged.city = std::move(city);
  return {classifyStaged(std::move(staged), gap, progress.part(0.3, 1, "classify")), std::move(diagnostics)};
}

StagedBuilding classifyStaged(StagedBuilding staged, double gap, const Progress& progress) {
  staged.classes = std::make_shared<const Classification>(classify(*staged.mesh, gap, progress));
  staged.pane = makePaneModel(staged.mesh, staged.classes.get());
  staged.counts = countsOf(*staged.mesh, *staged.classes);
  progress.report(1);
  return staged;
}

StagedLevel makeStagedLevel(const StagedBuilding& staged, std::shared_ptr<const Perception> perception,
                            const SimplifyOptions& options, const Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  StagedLevel level;
  level.options = options;
  level.perception = std::move(perception);
  level.a = options.a;
  const ComponentMesh& mesh = *staged.mesh;
  const bool known = options.gap == staged.classes->gap;
  const Classification own =
      known ? Classification{} : classify(mesh, options.gap, progress.part(0, 0.1, "classify"));
  const Classification& classes = known ? *staged.classes : own;
  const Progress rest = progress.part(0.1, 1, "simplify");
  Simplified simplified;
  if (options.aAuto && needsTopology(options.method)) {
    Measured best = simplifyAndMeasure(mesh, classes, options, rest, level.perception.get());
    level.a = best.a;
    level.trials = best.trials;
    if (known) level.report = reportOf(mesh, classes, best);
    if (level.report && level.perception)
      level.report->stage = stageReportOf(*level.perception, best.admission, best.simplified.mesh);
    simplified = std::move(best.simplified);
    level.admission = std::move(best.admission);
  } else if (level.perception) {
    Settled settled = simplifySettled(mesh, classes, *level.perception, options, rest);
    simplified = std::move(settled.simplified);
    level.admission = std::move(settled.admission);
  } else {
    simplified = simplify(mesh, classes, options, rest);
  }
  level.simplified = std::make_shared<const Simplified>(std::move(simplified));
  level.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  level.pane = makePaneModel(std::shared_ptr<const ComponentMesh>(level.simplified, &level.simplified->mesh),
                             level.simplified->component, level.simplified->vertex, *staged.pane);
  return level;
}

SimplifyReport measureStagedLevel(const StagedBuilding& staged, const StagedLevel& level,
                                  const Progress& progress) {
  Measured measured = measureSimplified(*staged.mesh, *staged.classes, *level.simplified, level.a, progress);
  measured.trials = level.trials;
  SimplifyReport report = reportOf(*staged.mesh, *staged.classes, measured);
  if (level.perception)
    report.stage = stageReportOf(*level.perception, level.admission, level.simplified->mesh);
  return report;
}

}  // namespace lodestone
