// The building on the stage of the Simplification view: what it is made of, and what methods make of it.
#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "algorithms/simplification/simplification.h"
#include "gui/view3d/pane_model.h"
#include "gui/view3d/surface_overlay.h"
#include "gui/workspace/workspace.h"
#include "model/component_mesh.h"
#include "model/perception.h"
#include "model/simplify_report.h"

namespace lodestone {

/// Vertices of a component by class.
struct ComponentCounts {
  std::array<std::uint32_t, 3> vertices{};  ///< by VertexClass
};

/// A building, or the group that it touches, with its classes. Never changed once made.
struct StagedBuilding {
  std::shared_ptr<const CityModel> city;
  std::vector<std::uint32_t> buildings;
  std::shared_ptr<const ComponentMesh> mesh;
  std::shared_ptr<const Classification> classes;
  std::shared_ptr<const PaneModel> pane;
  std::vector<ComponentCounts> counts;  ///< by component
  std::shared_ptr<const SurfaceLook> surfaces;
};

/// What a method made of it. Measured a while after it is drawn.
struct StagedLevel {
  SimplifyOptions options;
  std::shared_ptr<const Perception> perception;  ///< that said where it may be touched; null: nothing did
  Admission admission;                           ///< that it was made with; everything without a perception
  std::shared_ptr<const Simplified> simplified;
  std::shared_ptr<const PaneModel> pane;
  std::optional<SimplifyReport> report;
  double a = 0;                   ///< that was used
  std::vector<AutoTrial> trials;  ///< of the search for a, if it was searched for
  double seconds = 0;             ///< that the method took
};

/// Computes in the background; the last good result stays until a new one is there. Lives on the GUI thread.
class Stage : public QObject {
  Q_OBJECT

 public:
  /// The two methods of the view: the one that is set, and the one it is compared with.
  enum Method { A, B, MethodCount };
  static constexpr std::uint32_t kMostLiveTriangles = 50'000;

  explicit Stage(Workspace& workspace, QObject* parent = nullptr);
  ~Stage() override;

  /// Puts a building on the stage, with those that touch it or alone. opened() follows when it is classified.
  void open(NodeId building, bool withTouching = true);
  void close();
  [[nodiscard]] bool isOpening() const { return building_ != kNoNode && !staged_; }
  [[nodiscard]] bool isOpen() const { return staged_ != nullptr; }
  [[nodiscard]] NodeId building() const { return building_; }
  [[nodiscard]] bool withTouching() const { return withTouching_; }
  [[nodiscard]] QString title() const;
  [[nodiscard]] const std::shared_ptr<const StagedBuilding>& staged() const { return staged_; }
  [[nodiscard]] const std::optional<StagedLevel>& level(Method method) const { return levels_[method]; }

  [[nodiscard]] const SimplifyOptions& options(Method method) const;
  void setOptions(Method method, const SimplifyOptions& options, const QString& what);
  /// Whether method B is made and shown beside A.
  void setComparing(bool comparing);
  [[nodiscard]] bool comparing() const { return comparing_; }
  /// Small enough to be made again with every move of a slider.
  [[nodiscard]] bool isLive() const;
  /// What is shown of a method was made with other options than those set now.
  [[nodiscard]] bool isOutdated(Method method) const;
  /// Outdated, or not measured yet.
  [[nodiscard]] bool isUnfinished(Method method) const;
  [[nodiscard]] bool isComputing(Method method) const;
  /// Unfinished, and so it stays until compute(): it was stopped, or is too large to be live.
  [[nodiscard]] bool isStopped() const;
  /// Makes what is outdated now.
  void compute();
  void cancel();
  /// Makes a chain of what is shown of a method now, whatever is shown later; empty where there is nothing.
  [[nodiscard]] std::function<LodChain()> simplified(Method method) const;
  [[nodiscard]] static QString openTask() { return QStringLiteral("stage"); }
  [[nodiscard]] static QString methodTask(Method method);

  /// What pictures say of the original; null: nobody has looked yet. Levels that follow it are made again.
  [[nodiscard]] const std::shared_ptr<const Perception>& perception() const { return perception_; }
  void setPerception(std::shared_ptr<const Perception> perception);
  /// A method that is shown asks pictures where it may touch the model.
  [[nodiscard]] bool needsPictures() const;
  /// Of who looks: nothing that needs pictures is made meanwhile.
  [[nodiscard]] static QString picturesTask() { return QStringLiteral("perceive"); }

  [[nodiscard]] const std::vector<std::uint32_t>& selection() const { return selection_; }  ///< components
  void select(std::vector<std::uint32_t> components);
  void setHover(std::uint32_t component);
  [[nodiscard]] std::uint32_t hover() const { return hover_; }
  [[nodiscard]] std::optional<std::uint32_t> vertex() const { return vertex_; }
  void pickVertex(std::optional<std::uint32_t> vertex);
  /// A contact of the original, by its place in Classification::contacts.
  [[nodiscard]] std::optional<std::size_t> contact() const { return contact_; }
  void chooseContact(std::optional<std::size_t> contact);
  void flyTo(const Box3& box) { Q_EMIT flyRequested(box); }
  void flyToComponent(std::uint32_t component);
  void flyToContact(std::size_t contact);

 Q_SIGNALS:
  void opening();
  void opened();
  void closed();
  void optionsChanged();
  void comparingChanged();
  void levelChanged(lodestone::Stage::Method method);
  void computingChanged();
  void perceptionChanged();
  /// Somebody wants a level made that pictures say too little for.
  void picturesWanted();
  void selectionChanged();
  void hoverChanged();
  void vertexChanged();
  void contactChanged();
  void flyRequested(const lodestone::Box3& box);

 private:
  void onStateChanged(const ProjectState& before, const ProjectState& after);
  void classifyAgain();
  void take(StagedBuilding staged);
  void start(Method method);
  void measure(Method method);
  void forgetLevels();

  Workspace& workspace_;
  NodeId building_ = kNoNode;
  bool withTouching_ = true;
  bool comparing_ = false;
  bool awaitsPictures_ = false;  ///< compute() follows when they are there
  bool told_ = false;            ///< what there is to say of the building's triangles
  std::shared_ptr<const StagedBuilding> staged_;
  std::shared_ptr<const Perception> perception_;
  std::array<std::optional<StagedLevel>, MethodCount> levels_;
  std::vector<std::uint32_t> selection_;
  std::uint32_t hover_ = kNoNode;
  std::optional<std::uint32_t> vertex_;
  std::optional<std::size_t> contact_;
  QTimer debounce_;
};

}  // namespace lodestone
