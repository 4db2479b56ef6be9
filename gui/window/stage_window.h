// The Simplification view: one building on a stage, with docks of its own.
#pragma once

#include <QMainWindow>
#include <functional>

#include "gui/simplification/stage.h"
#include "gui/view3d/palette.h"

class QAction;
class QActionGroup;

namespace lodestone {

class ComponentsPanel;
class Perceiving;
class PerceptionPanel;
class Sight;
class SightLink;
class SightPanel;
class SimplifyPanel;
class StageLegend;
class StageLink;
class StageView;

class StageWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit StageWindow(Workspace& workspace, QWidget* parent = nullptr);
  ~StageWindow() override;

  [[nodiscard]] Stage& stage() { return *stage_; }
  [[nodiscard]] StageView& view() { return *view_; }
  [[nodiscard]] ComponentsPanel& components() { return *components_; }
  [[nodiscard]] SimplifyPanel& method() { return *method_; }
  [[nodiscard]] StageLegend& legend() { return *legend_; }
  [[nodiscard]] Sight& sight() { return *sight_; }
  [[nodiscard]] SightPanel& visibility() { return *visibility_; }
  [[nodiscard]] Perceiving& perceiving() { return *perceiving_; }
  [[nodiscard]] PerceptionPanel& perception() { return *perception_; }
  [[nodiscard]] const QList<QDockWidget*>& docks() const { return docks_; }
  /// Original alone, side by side, wipe.
  [[nodiscard]] QAction* layoutAction(int i) const { return layouts_[static_cast<std::size_t>(i)]; }

  void setTheme(SceneTheme theme);
  void useDefaultLayout();
  [[nodiscard]] QImage picture();

 Q_SIGNALS:
  void exportRequested();

 private:
  void makeToolBar();
  void makeDocks();
  void makeVisibilityDock();
  void showVisibility();
  void makePerceptionDock();
  [[nodiscard]] QList<QDockWidget*> docksBelow() const;
  void makeRoomForPerception();
  void showPerception(bool shown);
  void watchPerception();
  QDockWidget* addDock(const QString& name, const QString& title, QWidget* panel, Qt::DockWidgetArea area,
                       std::function<void()> beforeShown = {});

  Workspace& workspace_;
  Stage* stage_;
  StageView* view_;
  StageLegend* legend_;
  ComponentsPanel* components_ = nullptr;
  SimplifyPanel* method_ = nullptr;
  StageLink* link_ = nullptr;
  Sight* sight_;
  SightPanel* visibility_ = nullptr;
  SightLink* sightLink_ = nullptr;
  Perceiving* perceiving_;
  PerceptionPanel* perception_ = nullptr;
  QDockWidget* componentsDock_ = nullptr;
  QDockWidget* vertexDock_ = nullptr;
  QDockWidget* methodDock_ = nullptr;
  QDockWidget* measuresDock_ = nullptr;
  QDockWidget* contactsDock_ = nullptr;
  QDockWidget* curveDock_ = nullptr;
  QDockWidget* visibilityDock_ = nullptr;
  QDockWidget* perceptionDock_ = nullptr;
  QList<QDockWidget*> docks_;  ///< all of them
  std::array<QAction*, 3> layouts_{};
};

}  // namespace lodestone
