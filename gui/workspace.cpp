#include "gui/workspace.h"

#include <QFileInfo>
#include <algorithm>

#include "algorithms/cutting.h"
#include "algorithms/import.h"
#include "gui/jobs.h"
#include "model/io/project_file.h"

namespace lodestone {
namespace {

std::vector<std::filesystem::path> toPaths(const std::vector<std::string>& texts) {
  return {texts.begin(), texts.end()};
}

std::vector<std::string> toStrings(const QStringList& list) {
  std::vector<std::string> result;
  for (const QString& text : list) result.push_back(text.toStdString());
  return result;
}

QString titleOf(const QStringList& paths) {
  const QString first = paths.isEmpty() ? QString() : QFileInfo(paths.first()).fileName();
  return paths.size() > 1 ? Workspace::tr("%1 and %2 more").arg(first).arg(paths.size() - 1) : first;
}

std::uint64_t polygonsOf(const CityModel& city) {
  std::uint64_t sum = 0;
  for (const Building& building : city.buildings) sum += polygonCount(building.footprint);
  return sum;
}

}  // namespace

Workspace::Workspace(QObject* parent) : QObject(parent) {
  session_.listen(
      [this](const ProjectState& before, const ProjectState& after) { onStateChanged(before, after); });
  connect(&tasks_, &TaskRunner::diagnosed, this, &Workspace::diagnosed);
}

Workspace::~Workspace() = default;

void Workspace::commit(ProjectState next, const QString& what, const QString& mergeKey) {
  session_.commit(std::move(next), what.toStdString(), mergeKey.toStdString());
}

void Workspace::onStateChanged(const ProjectState& before, const ProjectState& after) {
  if (before.city != after.city) {
    polygonsOfAll_ = after.city ? polygonsOf(*after.city) : 0;
    selection_.clear();
    hover_ = kNoNode;
    frozenCamera_.reset();
    if (tasks_.busy(clusterTask())) tasks_.cancel(clusterTask());
  } else if (before.tree != after.tree) {
    const std::size_t nodes = after.tree   ? after.tree->nodes.size()
                              : after.city ? after.city->buildings.size()
                                           : 0;
    std::erase_if(selection_, [&](NodeId node) { return node >= nodes; });
    hover_ = kNoNode;
  }
  if (before.tree != after.tree) chain_.reset();
  Q_EMIT stateChanged(before, after);
  refreshCut();
  if (before.city != after.city || before.barriers != after.barriers) readBarriers();
  if (before.tree != after.tree) {
    Q_EMIT chainChanged();
    Q_EMIT selectionChanged();
  }
}

void Workspace::import(const QStringList& paths, const ImportOptions& options, bool thenCluster,
                       const QStringList& barriers) {
  ProjectState wanted;
  wanted.sources = toStrings(paths);
  wanted.importOptions = options;
  wanted.barriers = toStrings(barriers);
  wanted.clusterOptions = state().clusterOptions;
  wanted.mergeOptions = state().mergeOptions;
  wanted.cutOptions = state().cutOptions;
  const QString title = titleOf(paths);
  tasks_.start(
      importTask(), tr("Opening %1").arg(title),
      [sources = wanted.sources, options](const Progress& progress) {
        return importCity(toPaths(sources), options, progress);
      },
      [this, wanted, title, thenCluster](Result<CityModel> result) {
        commitImport(std::move(result), wanted, tr("Import %1").arg(title), thenCluster);
      });
}

void Workspace::commitImport(Result<CityModel> result, const ProjectState& wanted, const QString& what,
                             bool thenCluster) {
  if (!result.diagnostics.empty()) Q_EMIT diagnosed(result.diagnostics);
  if (!result) return;
  ProjectState next = wanted;
  next.city = std::make_shared<const CityModel>(std::move(*result));
  projectPath_.clear();
  recovered_ = false;
  commit(std::move(next), what);
  Q_EMIT imported();
  if (thenCluster && canCluster()) cluster();
}

void Workspace::openSample() {
  const QString path = samplePath();
  if (path.isEmpty()) {
    Q_EMIT diagnosed({diagnose(Code::FileNotFound, "resources/sample")});
    return;
  }
  const QStringList streets = sampleStreets();
  import({path}, {}, true, streets);
}

void Workspace::close() {
  projectPath_.clear();
  recovered_ = false;
  session_.reset({});
}

void Workspace::loadProjectFile(const QString& path, bool recovered) {
  Result<LoadedProject> loaded = loadProject(path.toStdString());
  if (!loaded.diagnostics.empty()) Q_EMIT diagnosed(loaded.diagnostics);
  if (!loaded) return;
  const ProjectState wanted = loaded->state;
  const QString layout = QString::fromStdString(loaded->layout);
  tasks_.start(
      importTask(), tr("Opening %1").arg(QFileInfo(path).fileName()),
      [wanted](const Progress& progress) {
        return importCity(toPaths(wanted.sources), wanted.importOptions, progress);
      },
      [this, wanted, path, layout, recovered](Result<CityModel> result) {
        if (!result.diagnostics.empty()) Q_EMIT diagnosed(result.diagnostics);
        if (!result) return;
        ProjectState next = wanted;
        next.city = std::make_shared<const CityModel>(std::move(*result));
        session_.reset(next);
        if (recovered) session_.commit(std::move(next), tr("Recover work").toStdString());
        projectPath_ = recovered ? QString() : path;
        recovered_ = recovered;
        Q_EMIT imported();
        Q_EMIT projectOpened(path, layout);
        if (canCluster()) cluster();
      });
}

bool Workspace::saveProject(const QString& path, const QString& layout) {
  ProjectState toSave = state();
  toSave.camera = camera_;
  const Result<bool> saved = lodestone::saveProject(toSave, path.toStdString(), layout.toStdString());
  if (!saved.diagnostics.empty()) Q_EMIT diagnosed(saved.diagnostics);
  return saved.ok();
}

void Workspace::markSaved(const QString& path) {
  projectPath_ = path;
  recovered_ = false;
  session_.markSaved();
}

void Workspace::setClusterOptions(const ClusterOptions& options, const QString& what) {
  if (options == state().clusterOptions) return;
  ProjectState next = state();
  next.clusterOptions = options;
  commit(std::move(next), what, what);
}

void Workspace::setMergeOptions(const MergeOptions& options, const QString& what) {
  if (options == state().mergeOptions) return;
  ProjectState next = state();
  next.mergeOptions = options;
  commit(std::move(next), what, what);
}

void Workspace::setCutOptions(const CutOptions& options, const QString& what) {
  const bool follows = state().cutChoice.mode == CutMode::Camera;
  if (options == state().cutOptions && follows) return;
  ProjectState next = state();
  next.cutOptions = options;
  next.cutChoice = {};
  commit(std::move(next), what, what);
}

void Workspace::setCutChoice(const CutChoice& choice) {
  if (choice == state().cutChoice) return;
  ProjectState next = state();
  next.cutChoice = choice;
  commit(std::move(next), tr("Move the cut"), QStringLiteral("cut-%1").arg(static_cast<int>(choice.mode)));
}

void Workspace::setBarriers(const QStringList& paths) {
  ProjectState next = state();
  next.barriers = toStrings(paths);
  if (next.barriers != state().barriers) commit(std::move(next), tr("Change barriers"));
}

void Workspace::readBarriers() {
  const auto city = state().city;
  const auto paths = state().barriers;
  if (!city || paths.empty()) {
    barrierLines_.clear();
    Q_EMIT barrierLinesChanged();
    return;
  }
  tasks_.start(
      QStringLiteral("barriers"), tr("Reading barrier lines"),
      [city, paths](const Progress& progress) { return readBarrierLines(*city, paths, progress); },
      [this, city, paths](Result<std::vector<LineLayer>> result) {
        if (state().city != city || state().barriers != paths) return;
        if (!result.diagnostics.empty()) Q_EMIT diagnosed(result.diagnostics);
        barrierLines_ = result ? std::move(*result) : std::vector<LineLayer>{};
        Q_EMIT barrierLinesChanged();
      });
}

bool Workspace::canCluster() const {
  return state().city && !state().city->buildings.empty();
}

bool Workspace::treeOutdated() const {
  const auto& tree = state().tree;
  return tree && (tree->dendrogram->options != state().clusterOptions ||
                  tree->options != state().mergeOptions || state().treeBarriers != state().barriers);
}

void Workspace::cluster() {
  if (!canCluster()) return;
  const ProjectState snapshot = state();
  tasks_.start(
      clusterTask(), tr("Clustering"),
      [snapshot](const Progress& progress) { return makeTree(snapshot, progress); },
      [this, snapshot](Result<std::shared_ptr<const ClusterTree>> result) {
        if (state().city != snapshot.city) return;
        if (!result.diagnostics.empty()) Q_EMIT diagnosed(result.diagnostics);
        if (!result) return;
        ProjectState next = state();
        next.tree = std::move(*result);
        next.treeBarriers = snapshot.barriers;
        commit(std::move(next), tr("Cluster"));
      });
}

void Workspace::setCamera(const Camera& camera) {
  if (camera == camera_) return;
  camera_ = camera;
  if (!frozenCamera_ && state().cutChoice.mode == CutMode::Camera) refreshCut();
}

void Workspace::setCameraFrozen(bool frozen) {
  if (frozen == cameraFrozen()) return;
  frozenCamera_ = frozen ? std::optional<Camera>(camera_) : std::nullopt;
  refreshCut();
}

void Workspace::refreshCut() {
  const auto& tree = state().tree;
  const CutChoice& choice = state().cutChoice;
  cut_.reset();
  if (tree && choice.mode != CutMode::Original) {
    Cut cut;
    if (choice.mode == CutMode::Weight) {
      cut = makeWeightCut(*tree, choice.value);
    } else if (choice.mode == CutMode::Tolerance) {
      cut = makeUniformCut(*tree, state().cutOptions, choice.value);
    } else {
      cut = makeCut(*tree, state().cutOptions, frozenCamera_.value_or(camera_));
    }
    cut_ = std::make_shared<const Cut>(std::move(cut));
  }
  Q_EMIT cutChanged();
}

std::uint64_t Workspace::polygonsDrawn() const {
  return cut_ ? cut_->polygons : polygonsOfAll_;
}

void Workspace::makeChainPreview(const ChainOptions& options) {
  const ProjectState snapshot = state();
  if (!snapshot.city) return;
  tasks_.start(
      QStringLiteral("chain"), tr("Measuring levels"),
      [snapshot, options](const Progress& progress) {
        return makeChain(snapshot.city, snapshot.tree, options, progress);
      },
      [this, snapshot](Result<LodChain> result) {
        if (state().tree != snapshot.tree || state().city != snapshot.city) return;
        if (!result.diagnostics.empty()) Q_EMIT diagnosed(result.diagnostics);
        chain_ = std::move(result.value);
        Q_EMIT chainChanged();
      });
}

void Workspace::exportChain(const ExportRequest& request) {
  const ProjectState snapshot = state();
  if (!snapshot.city) return;
  tasks_.start(
      exportTask(), tr("Exporting %1").arg(QString::fromStdString(request.name)),
      [snapshot, request, cut = cut_](const Progress& progress) {
        return writeChain(snapshot, cut, request, progress);
      },
      [this](const Result<WriteReport>& result) {
        if (!result.diagnostics.empty()) Q_EMIT diagnosed(result.diagnostics);
        QStringList files;
        if (result) {
          for (const auto& file : result->files) files << QString::fromStdString(file.string());
        }
        Q_EMIT exported(files);
      });
}

void Workspace::select(std::vector<NodeId> nodes) {
  if (nodes == selection_) return;
  selection_ = std::move(nodes);
  Q_EMIT selectionChanged();
}

void Workspace::setHover(NodeId node) {
  if (node == hover_) return;
  hover_ = node;
  Q_EMIT hoverChanged();
}

NodeId Workspace::buildingOf(const std::string& objectId) const {
  if (!state().city || objectId.empty()) return kNoNode;
  const auto& buildings = state().city->buildings;
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    bool found = false;
    forEachObject(buildings[i].object,
                  [&](const CityObject& object) { found = found || object.id == objectId; });
    if (found) return static_cast<NodeId>(i);
  }
  return kNoNode;
}

QString Workspace::nameOf(NodeId node) const {
  if (!state().city || node == kNoNode) return {};
  const auto& buildings = state().city->buildings;
  if (node < buildings.size()) return QString::fromStdString(buildings[node].object.id);
  if (!state().tree || node >= state().tree->nodes.size()) return {};
  return tr("Cluster of %L1 buildings").arg(state().tree->nodes[node].size);
}

}  // namespace lodestone
