#include "gui/workspace/workspace.h"

#include <algorithm>

#include "gui/workspace/jobs.h"
#include "gui/workspace/same_clusters.h"
#include "model/exterior.h"

namespace lodestone {
namespace {

FaceCount facesOfAll(const CityModel& city) {
  FaceCount sum;
  for (const Building& building : city.buildings) sum += facesOf(building);
  return sum;
}

}  // namespace

Workspace::Workspace(QObject* parent) : QObject(parent) {
  session_.listen(
      [this](const ProjectState& before, const ProjectState& after) { onStateChanged(before, after); });
  connect(&tasks_, &TaskRunner::diagnosed, this, &Workspace::diagnosed);
}

Workspace::~Workspace() = default;

const Workspace::Home& Workspace::home() const {
  static const Home none;
  const auto found = homes_.find(state().project);
  return found == homes_.end() ? none : found->second;
}

std::uint32_t Workspace::newProject(const Home& home) {
  homes_[++lastProject_] = home;
  return lastProject_;
}

void Workspace::commit(ProjectState next, const QString& what, const QString& mergeKey) {
  homes_[next.project].edited = true;
  commitStep(std::move(next), what, mergeKey);
}

void Workspace::commitStep(ProjectState next, const QString& what, const QString& mergeKey) {
  session_.commit(std::move(next), what.toStdString(), mergeKey.toStdString());
}

void Workspace::onStateChanged(const ProjectState& before, const ProjectState& after) {
  const std::vector<NodeId> selected = selection_;
  if (before.city != after.city) {
    facesOfAll_ = after.city ? lodestone::facesOfAll(*after.city) : FaceCount{};
    selection_.clear();
    hover_ = kNoNode;
    frozenCamera_.reset();
    if (tasks_.busy(clusterTask())) tasks_.cancel(clusterTask());
  } else if (before.tree != after.tree) {
    selection_ = sameClusters(before.tree.get(), after.tree.get(), selection_);
    hover_ = kNoNode;
  }
  if (before.tree != after.tree) chain_.reset();
  Q_EMIT stateChanged(before, after);
  const bool sameCut = before.city == after.city && before.tree == after.tree &&
                       before.chainOptions.cut == after.chainOptions.cut &&
                       before.cutChoice == after.cutChoice;
  if (!sameCut) refreshCut();
  const bool sameLayer = before.clusterOptions.barrierLayer == after.clusterOptions.barrierLayer;
  if (before.city != after.city || before.barriers != after.barriers || !sameLayer) readBarriers();
  if (before.tree != after.tree) Q_EMIT chainChanged();
  if (selection_ != selected || before.tree != after.tree) Q_EMIT selectionChanged();
  makeDroppedTree(before, after);
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
  if (options == state().chainOptions.cut && follows) return;
  if (!follows) frozenCamera_.reset();
  ProjectState next = state();
  next.chainOptions.cut = options;
  next.cutChoice = {};
  commit(std::move(next), what, what);
}

void Workspace::setChainOptions(ChainOptions options, const QString& what) {
  options.cut = state().chainOptions.cut;
  if (options == state().chainOptions) return;
  ProjectState next = state();
  next.chainOptions = std::move(options);
  commit(std::move(next), what, what);
}

void Workspace::setSimplifyOptions(bool compared, const SimplifyOptions& options, const QString& what) {
  ProjectState next = state();
  SimplifyOptions& own = compared ? next.comparedOptions : next.simplifyOptions;
  if (options == own) return;
  own = options;
  commit(std::move(next), what, what + (compared ? QStringLiteral("-b") : QStringLiteral("-a")));
}

void Workspace::setPerceiveOptions(const PerceiveOptions& options, const QString& what) {
  if (options == state().perceiveOptions) return;
  ProjectState next = state();
  next.perceiveOptions = options;
  commit(std::move(next), what, what);
}

void Workspace::setSight(const SightOptions& sight, const QString& what, const QString& mergeKey) {
  if (!state().city || sight == state().sight) return;
  ProjectState next = state();
  next.sight = sight;
  commit(std::move(next), what, mergeKey);
}

void Workspace::setCutChoice(const CutChoice& choice) {
  if (choice == state().cutChoice) return;
  ProjectState next = state();
  next.cutChoice = choice;
  commitStep(std::move(next), tr("Move the cut"),
             QStringLiteral("cut-%1").arg(static_cast<int>(choice.mode)));
}

void Workspace::setBarriers(const QStringList& paths) {
  ProjectState next = state();
  next.barriers = toStrings(paths);
  if (next.barriers != state().barriers) commit(std::move(next), tr("Change barriers"));
}

void Workspace::setLooks(const QByteArray& looks, const QString& what, const QString& mergeKey) {
  if (!state().city || looks.toStdString() == state().looks) return;
  ProjectState next = state();
  next.looks = looks.toStdString();
  commit(std::move(next), what, mergeKey);
}

void Workspace::readBarriers() {
  const auto city = state().city;
  const auto paths = state().barriers;
  const auto layer = state().clusterOptions.barrierLayer;
  if (!city || paths.empty()) {
    barrierLines_.clear();
    Q_EMIT barrierLinesChanged();
    return;
  }
  tasks_.start(
      QStringLiteral("barriers"), tr("Reading barrier lines"),
      [city, paths, layer](const Progress& progress) {
        return readBarrierLines(*city, paths, layer, progress);
      },
      [this, city, paths, layer](Result<std::vector<LineLayer>> result) {
        if (state().city != city || state().barriers != paths) return;
        if (state().clusterOptions.barrierLayer != layer) return;
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
  const TreeRecipe recipe{state().clusterOptions, state().mergeOptions, state().barriers};
  tasks_.start(
      clusterTask(), tr("Clustering"),
      [city = state().city, recipe](const Progress& progress) { return makeTree(*city, recipe, progress); },
      [this, city = state().city, recipe](Result<std::shared_ptr<const ClusterTree>> result) {
        if (state().city != city) return;
        if (!result.diagnostics.empty()) Q_EMIT diagnosed(result.diagnostics);
        if (!result) return;
        ProjectState next = state();
        next.tree = std::move(*result);
        next.treeBarriers = recipe.barriers;
        next.droppedTree.reset();
        commitStep(std::move(next), tr("Cluster"));
      });
}

void Workspace::makeDroppedTree(const ProjectState& before, const ProjectState& after) {
  if (!after.droppedTree || !canCluster()) return;
  const bool same = before.city == after.city && before.droppedTree == after.droppedTree;
  if (same) return;  // on its way, or stopped by a person
  // A tree that the history had before said all it has to say then.
  const bool opened = !session_.canUndo() && !session_.canRedo();
  tasks_.start(
      clusterTask(), tr("Clustering"),
      [city = after.city, recipe = *after.droppedTree](const Progress& progress) {
        return makeTree(*city, recipe, progress);
      },
      [this, city = after.city, recipe = *after.droppedTree,
       opened](Result<std::shared_ptr<const ClusterTree>> result) {
        if (state().city != city) return;
        if (!result.diagnostics.empty() && (opened || !result)) Q_EMIT diagnosed(result.diagnostics);
        session_.giveTree(city, recipe, result.value.value_or(nullptr));
      });
}

void Workspace::setCamera(const Camera& camera) {
  if (camera == camera_) return;
  camera_ = camera;
  if (!frozenCamera_ && state().cutChoice.mode == CutMode::Camera) refreshCut();
}

void Workspace::chooseByCamera(bool frozen) {
  frozenCamera_ = frozen ? std::optional<Camera>(camera_) : std::nullopt;
  state().cutChoice.mode == CutMode::Camera ? refreshCut() : setCutChoice({});
}

void Workspace::refreshCut() {
  cut_ = chosenCut(state(), frozenCamera_.value_or(camera_));
  Q_EMIT cutChanged();
}

QString Workspace::polygonHelp() {
  return tr(
      "Polygons of the buildings, clusters and landmarks drawn now, as the legible paper counts them: a wall "
      "quad is one, of every other face each triangle, the ground none; and their share of what all "
      "buildings have when each is drawn itself. A share above 100% is no mistake: landmarks are drawn "
      "beside the cluster that stands for them too.");
}

void Workspace::makeChainPreview() {
  const ProjectState snapshot = state();
  if (!snapshot.city) return;
  tasks_.start(
      QStringLiteral("chain"), tr("Measuring levels"),
      [snapshot](const Progress& progress) {
        return makeChain(snapshot.city, snapshot.tree, snapshot.chainOptions, progress);
      },
      [this, snapshot](Result<LodChain> result) {
        if (state().tree != snapshot.tree || state().city != snapshot.city) return;
        if (!result.diagnostics.empty()) Q_EMIT diagnosed(result.diagnostics);
        chain_ = std::move(result.value);
        measuredWith_ = snapshot.chainOptions;
        Q_EMIT chainChanged();
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

std::vector<NodeId> Workspace::buildingsOf(const std::set<std::string>& objectIds) const {
  std::vector<NodeId> found;
  if (!state().city || objectIds.empty()) return found;
  const auto& buildings = state().city->buildings;
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    bool has = false;
    forEachObject(buildings[i].object,
                  [&](const CityObject& object) { has = has || objectIds.contains(object.id); });
    if (has) found.push_back(static_cast<NodeId>(i));
  }
  return found;
}

QString Workspace::nameOf(NodeId node) const {
  if (!state().city || node == kNoNode) return {};
  const auto& buildings = state().city->buildings;
  if (node < buildings.size()) return QString::fromStdString(buildings[node].object.id);
  if (!state().tree || node >= state().tree->nodes.size()) return {};
  return tr("Cluster of %L1 buildings").arg(state().tree->nodes[node].size);
}

}  // namespace lodestone
