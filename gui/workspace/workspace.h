// The workbench without its widgets: the open project, what is computed from it, and what is selected.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "algorithms/chains/chain_building.h"
#include "gui/workspace/task_runner.h"
#include "model/io/format.h"
#include "model/session.h"

namespace lodestone {

/// What an export dialog asked for.
struct ExportRequest {
  std::vector<std::string> formats;  ///< ids
  bool drawnCut = false;             ///< write what is drawn now instead of the chain's levels
  std::filesystem::path folder;
  std::string name;  ///< files are <name> with the format's ending
};

/// Every file was named by a person: a model without one of them would be taken for the whole.
[[nodiscard]] bool leavesAnyOut(const Diagnostics& diagnostics);

/// One Session and one TaskRunner; every panel talks to this and to no other panel. Lives on the GUI thread.
class Workspace : public QObject {
  Q_OBJECT

 public:
  explicit Workspace(QObject* parent = nullptr);
  ~Workspace() override;

  [[nodiscard]] const ProjectState& state() const { return session_.state(); }
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] TaskRunner& tasks() { return tasks_; }

  /// All files become one model. What was open stays until the new model is there, and comes back by undo.
  void import(const QStringList& paths, const ImportOptions& options, bool thenCluster = false,
              const QStringList& barriers = {});
  /// The files join those of the open model, which stays until the new one is there, and for good when any
  /// file could not be read. The project keeps its place, its barriers and its history, and what is changed
  /// in the meantime. \pre a model is open.
  void addToModel(const QStringList& paths, const ImportOptions& options);
  /// All files of the open model with other options, as addToModel() does. \pre a model is open.
  void readAgain(const ImportOptions& options);
  void openSample();
  void close();  ///< forgets the model and its history
  void openProject(const QString& path) { loadProjectFile(path, false); }
  /// Work that an autosave kept: opened as unsaved work without a place of its own.
  void recoverProject(const QString& path) { loadProjectFile(path, true); }
  /// Whether closing would lose work: a changed project, recovered work, or settings that were changed. A
  /// fresh import, its clusters and the place of the cut can be made again.
  [[nodiscard]] bool hasUnsavedWork() const {
    return session_.modified() && (home().recovered || home().edited || !home().path.isEmpty());
  }
  /// False, with a diagnostic told, when it cannot be written.
  bool saveProject(const QString& path, const QString& layout);
  /// The project now lives at `path`, with nothing unsaved.
  void markSaved(const QString& path);
  [[nodiscard]] const QString& projectPath() const { return home().path; }

  void setClusterOptions(const ClusterOptions& options, const QString& what);
  void setMergeOptions(const MergeOptions& options, const QString& what);
  /// ε and α; the camera chooses by them again, whatever chose before.
  void setCutOptions(const CutOptions& options, const QString& what);
  /// The levels of the chain, with the ε and α that are set.
  void setChainOptions(ChainOptions options, const QString& what);
  /// Of the Simplification view: its method, or the one that it is compared with.
  void setSimplifyOptions(bool compared, const SimplifyOptions& options, const QString& what);
  void setPerceiveOptions(const PerceiveOptions& options, const QString& what);
  /// The viewpoint of the Simplification view; changes with one `mergeKey` are undone together.
  void setSight(const SightOptions& sight, const QString& what, const QString& mergeKey = {});
  void setBarriers(const QStringList& paths);
  /// How the layers look: saved with the project, and taken back by undo. Nothing while no model is open.
  void setLooks(const QByteArray& looks, const QString& what, const QString& mergeKey = {});
  /// Lines of the barrier files, as far as they are read.
  [[nodiscard]] const std::vector<LineLayer>& barrierLines() const { return barrierLines_; }
  /// Dendrogram and merged hulls, in the background.
  void cluster();
  [[nodiscard]] bool canCluster() const;
  /// The tree was made with other options or barriers than those set now.
  [[nodiscard]] bool treeOutdated() const;
  static QString clusterTask() { return QStringLiteral("cluster"); }
  static QString importTask() { return QStringLiteral("import"); }
  static QString exportTask() { return QStringLiteral("export"); }

  void setCutChoice(const CutChoice& choice);
  /// What is drawn; null while there is no tree, or when every building is drawn itself.
  [[nodiscard]] const std::shared_ptr<const Cut>& cut() const { return cut_; }
  /// The camera that is looked through; the cut follows it, unless it is frozen or chosen otherwise.
  void setCamera(const Camera& camera);
  [[nodiscard]] const Camera& camera() const { return camera_; }
  /// The camera chooses the cut, whatever chose it before: the one that is looked through, or, frozen, the
  /// one of now for good.
  void chooseByCamera(bool frozen);
  [[nodiscard]] bool cameraFrozen() const {
    return frozenCamera_ && state().cutChoice.mode == CutMode::Camera;
  }
  [[nodiscard]] const FaceCount& facesDrawn() const { return cut_ ? cut_->faces : facesOfAll_; }
  /// Of all buildings, each drawn itself: what facesDrawn() is a share of.
  [[nodiscard]] const FaceCount& facesOfAll() const { return facesOfAll_; }
  /// What these two count.
  [[nodiscard]] static QString polygonHelp();

  /// Chain of the present tree, in the background; chainChanged() follows.
  void makeChainPreview();
  [[nodiscard]] const std::optional<LodChain>& chain() const { return chain_; }
  /// The chain was measured with other options than those set now.
  [[nodiscard]] bool chainOutdated() const { return chain_ && measuredWith_ != state().chainOptions; }
  /// In the background, after the exports asked for before.
  void exportChain(const ExportRequest& request);
  /// The same for a chain that `make` makes on the worker thread of some of the buildings.
  void exportBuildings(const ExportRequest& request, std::function<LodChain()> make);

  [[nodiscard]] const std::vector<NodeId>& selection() const { return selection_; }
  void select(std::vector<NodeId> nodes);
  [[nodiscard]] NodeId hover() const { return hover_; }
  void setHover(NodeId node);
  void flyTo(NodeId node) { Q_EMIT flyRequested(node); }
  /// Buildings that have one of these ids, or a part that has, ascending. Cost: linear in the objects.
  [[nodiscard]] std::vector<NodeId> buildingsOf(const std::set<std::string>& objectIds) const;
  /// "Town hall", "Cluster of 12 buildings".
  [[nodiscard]] QString nameOf(NodeId node) const;

 Q_SIGNALS:
  void stateChanged(const lodestone::ProjectState& before, const lodestone::ProjectState& after);
  void imported();
  void projectOpened(const QString& path, const QString& layout);
  void cutChanged();
  void barrierLinesChanged();
  void chainChanged();
  void selectionChanged();
  void hoverChanged();
  void flyRequested(lodestone::NodeId node);
  void exported(const QStringList& files);
  void diagnosed(const lodestone::Diagnostics& diagnostics);
  /// Messages of an import that came to nothing: about no city that is open.
  void importRejected(const lodestone::Diagnostics& diagnostics);

 private:
  /// Where a project lives, and what is known of it.
  struct Home {
    QString path;
    bool recovered = false;
    bool edited = false;
  };
  [[nodiscard]] const Home& home() const;
  [[nodiscard]] Home& home() { return homes_[state().project]; }
  /// A project of its own, such as what is opened instead.
  [[nodiscard]] std::uint32_t newProject(const Home& home);
  /// An import under way, and what follows it.
  struct ImportPlan {
    ProjectState wanted;  ///< with the city that it started from, if the project is kept
    QString what;         ///< for undo
    bool thenCluster = false;
    bool keepsProject = false;
  };
  void readModelWith(const QStringList& more, const ImportOptions& options, const QString& what,
                     const QString& title);
  void startImport(const ImportPlan& plan, const QString& title);
  void commitImport(Result<CityModel> result, const ImportPlan& plan);
  void commitAdded(CityModel city, const ImportPlan& plan);
  [[nodiscard]] std::optional<std::string> sourceReplacedBy(const ExportRequest& request) const;
  void enqueueExport(const ExportRequest& request, std::function<Result<WriteReport>(const Progress&)> write);
  void loadProjectFile(const QString& path, bool recovered);
  void makeDroppedTree(const ProjectState& before, const ProjectState& after);
  /// A step that a person made; commitStep() for those that can be made again.
  void commit(ProjectState next, const QString& what, const QString& mergeKey = {});
  void commitStep(ProjectState next, const QString& what, const QString& mergeKey = {});
  void onStateChanged(const ProjectState& before, const ProjectState& after);
  void readBarriers();
  void refreshCut();

  Session session_;
  std::shared_ptr<const Cut> cut_;
  Camera camera_;
  std::optional<Camera> frozenCamera_;  ///< kept by other choices, for when they are undone
  FaceCount facesOfAll_;
  std::vector<LineLayer> barrierLines_;
  std::optional<LodChain> chain_;
  ChainOptions measuredWith_;
  std::vector<NodeId> selection_;
  NodeId hover_ = kNoNode;
  std::map<std::uint32_t, Home> homes_;  ///< by ProjectState::project
  std::uint32_t lastProject_ = 0;        ///< no number is given twice
  TaskRunner tasks_;                     // last: its destructor waits for workers
};

}  // namespace lodestone
