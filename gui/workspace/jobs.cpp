#include "gui/workspace/jobs.h"

#include <QCoreApplication>
#include <QDir>
#include <optional>
#include <system_error>

#include "algorithms/clustering/clustering.h"
#include "algorithms/merging/cutting.h"
#include "algorithms/merging/merging.h"
#include "model/io/atomic_file.h"
#include "model/io/read_city.h"
#include "model/io/recipe.h"

namespace lodestone {
namespace {

void append(Diagnostics& to, const Diagnostics& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// The folder of the sample town: installed beside the program, or in the source tree that the program was
/// built in.
std::optional<QDir> sampleFolder() {
  QDir folder(QCoreApplication::applicationDirPath());
  const QDir installed(folder.filePath(QStringLiteral("../share/lodestone/sample")));
  if (installed.exists()) return installed;
  do {
    const QDir sources(folder.filePath(QStringLiteral("resources/sample")));
    if (sources.exists()) return sources;
  } while (folder.cdUp());
  return std::nullopt;
}

QStringList sampleFiles(const QString& pattern) {
  QStringList paths;
  const std::optional<QDir> folder = sampleFolder();
  if (!folder) return paths;
  for (const QString& name : folder->entryList({pattern}, QDir::Files, QDir::Name))
    paths << folder->absoluteFilePath(name);
  return paths;
}

/// What makes the chain again, for formats that cannot hold it.
void writeRecipe(const std::string& recipe, const ExportRequest& request, Result<WriteReport>& report) {
  const auto path = request.folder / (request.name + ".recipe.json");
  try {
    writeFile(path, recipe);
    report->files.push_back(path);
  } catch (const std::system_error& error) {
    report.diagnostics.push_back(diagnose(Code::OutputUnwritable, error.what()));
  }
}

}  // namespace

std::vector<std::string> toStrings(const QStringList& list) {
  std::vector<std::string> result;
  for (const QString& text : list) result.push_back(text.toStdString());
  return result;
}

QString samplePath() {
  return sampleFiles(QStringLiteral("*.city.json")).value(0);
}
QStringList sampleStreets() {
  return sampleFiles(QStringLiteral("*streets*.geojson"));
}

Result<std::vector<LineLayer>> readBarrierLines(const CityModel& city, const std::vector<std::string>& paths,
                                                const std::string& layer, const Progress& progress) {
  std::vector<LineLayer> layers;
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const double share = 1.0 / static_cast<double>(paths.size());
    Result<LineLayer> lines =
        readLines(paths[i], city, layer,
                  progress.part(static_cast<double>(i) * share, static_cast<double>(i + 1) * share, "lines"));
    append(diagnostics, lines.diagnostics);
    if (lines) layers.push_back(std::move(*lines));
  }
  return {std::move(layers), std::move(diagnostics)};
}

Result<std::shared_ptr<const ClusterTree>> makeTree(const CityModel& city, const TreeRecipe& recipe,
                                                    const Progress& progress) {
  Result<std::vector<LineLayer>> barriers = readBarrierLines(
      city, recipe.barriers, recipe.clusterOptions.barrierLayer, progress.part(0, 0.05, "barriers"));
  Diagnostics diagnostics = std::move(barriers.diagnostics);
  // A tree made without a barrier that it is said to have kept would be wrong without a word.
  if (barriers->size() < recipe.barriers.size())
    return Result<std::shared_ptr<const ClusterTree>>::failure(std::move(diagnostics));
  Result<ClusterContext> context = clusterContext(city, recipe.clusterOptions, *barriers);
  append(diagnostics, context.diagnostics);
  if (!context) return Result<std::shared_ptr<const ClusterTree>>::failure(std::move(diagnostics));
  auto footprints = std::make_shared<const FootprintTable>(footprintTable(city));
  auto dendrogram = std::make_shared<const Dendrogram>(
      makeDendrogram(*footprints, recipe.clusterOptions, *context, progress.part(0.05, 0.7, "cluster")));
  auto tree = std::make_shared<const ClusterTree>(
      makeClusterTree(footprints, dendrogram, recipe.mergeOptions, progress.part(0.7, 1, "merge")));
  return {std::move(tree), std::move(diagnostics)};
}

Cut makeWeightCut(const ClusterTree& tree, double weight) {
  Cut cut;
  const std::vector<NodeId> nodes = nodesAtWeight(tree, weight);
  cut.drawn.reserve(nodes.size());
  for (const NodeId node : nodes) {
    cut.draw(tree, {node, tree.isLeaf(node) ? DrawRole::Building : DrawRole::Cluster, kNoNode, 0, 0});
  }
  return cut;
}

std::shared_ptr<const Cut> chosenCut(const ProjectState& state, const Camera& camera) {
  const CutChoice& choice = state.cutChoice;
  if (!state.tree || choice.mode == CutMode::Original) return nullptr;
  Cut cut;
  if (choice.mode == CutMode::Weight) {
    cut = makeWeightCut(*state.tree, choice.value);
  } else if (choice.mode == CutMode::Tolerance) {
    cut = makeUniformCut(*state.tree, state.chainOptions.cut, choice.value);
  } else {
    cut = makeCut(*state.tree, state.chainOptions.cut, camera);
  }
  return std::make_shared<const Cut>(std::move(cut));
}

Result<WriteReport> writeFormats(const LodChain& chain, Diagnostics said, const ExportRequest& request,
                                 const Progress& progress) {
  Result<WriteReport> report(WriteReport{}, std::move(said));
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(request.formats.size(), 1));
  double begin = 0;
  for (const std::string& id : request.formats) {
    const Format* format = formatById(id);
    if (!format || !format->write) {
      report.diagnostics.push_back(diagnose(Code::OutputFormatUnknown, id));
      continue;
    }
    const auto path = request.folder / (request.name + std::string(format->extensions.front()));
    const Progress part = progress.part(begin, begin + share, id);
    Result<WriteReport> written = format->write(chain, path, {}, part);
    progress.checkpoint();
    append(report.diagnostics, written.diagnostics);
    if (written) report->files.insert(report->files.end(), written->files.begin(), written->files.end());
    begin += share;
  }
  return report;
}

Result<WriteReport> writeChain(ProjectState state, const Camera& camera, const ExportRequest& request,
                               const Progress& progress) {
  Diagnostics said;
  if (state.droppedTree) {
    auto tree = makeTree(*state.city, *state.droppedTree, progress.part(0, 0.15, "cluster"));
    append(said, tree.diagnostics);
    if (!tree) return Result<WriteReport>::failure(std::move(tree.diagnostics));
    state.tree = std::move(*tree);
    state.treeBarriers = state.droppedTree->barriers;
  }
  Result<LodChain> chain =
      makeChain(state.city, state.tree, state.chainOptions, progress.part(0.15, 0.2, "levels"));
  if (!chain) return Result<WriteReport>::failure(std::move(chain.diagnostics));
  Recipe recipe = recipeOf(*chain, request.formats);
  recipe.sources = state.sources;
  recipe.import = values(state.importOptions);
  recipe.barriers = state.tree ? state.treeBarriers : std::vector<std::string>();
  chain->recipe = recipeText(recipe, request.folder);
  const auto cut = request.drawnCut ? chosenCut(state, camera) : nullptr;
  if (cut) {
    chain->levels = {levelOfCut(state.city, state.tree, *cut)};
    chain->recipe.clear();  // it makes the chain, not what was drawn
  }
  append(said, chain.diagnostics);
  Result<WriteReport> report = writeFormats(*chain, std::move(said), request, progress.part(0.2, 1, "write"));
  if (!cut && !report->files.empty()) writeRecipe(chain->recipe, request, report);
  return report;
}

}  // namespace lodestone
