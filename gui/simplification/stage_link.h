// Keeps the panes, the stage and its panels saying the same.
#pragma once

#include <QObject>
#include <array>
#include <memory>

#include "gui/simplification/stage.h"
#include "gui/view3d/building_scene.h"

namespace lodestone {

class ComponentsPanel;
class StageLegend;
class StageView;

class StageLink : public QObject {
  Q_OBJECT

 public:
  enum class Show { Original, Side, Wipe };

  StageLink(Stage& stage, StageView& view, ComponentsPanel& components, StageLegend& legend,
            QObject* parent = nullptr);

  void show(Show show);
  [[nodiscard]] Show shown() const { return show_; }
  void setTheme(SceneTheme theme);

 private:
  void connectStage();
  void connectView();
  void showBuilding();
  void showLevel(Stage::Method method);
  void showContacts();
  void showPanes();
  void showLook();
  void showTitles();
  void paintOriginal();
  void paintLevel(Stage::Method method);

  Stage& stage_;
  StageView& view_;
  ComponentsPanel& components_;
  StageLegend& legend_;
  Show show_ = Show::Side;
  /// By pane, in the colours of the classes that the stage's perception gives; null: nothing to paint.
  std::array<std::shared_ptr<const PaintedTriangles>, BuildingScene::kPanes> details_;
  SceneTheme theme_ = SceneTheme::Light;
};

}  // namespace lodestone
