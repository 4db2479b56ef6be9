// The city's 3D view as a widget.
#pragma once

#include "gui/surfaces/scene_widget.h"
#include "gui/view3d/city_scene.h"

namespace lodestone {

class SceneLegend;

/// Shows a CityScene, and tells what is pointed at.
class Viewport : public SceneWidget {
  Q_OBJECT

 public:
  explicit Viewport(QWidget* parent = nullptr);

  [[nodiscard]] CityScene& scene() { return *scene_; }
  [[nodiscard]] const CityScene& scene() const { return *scene_; }
  [[nodiscard]] const SceneLegend& legend() const { return *legend_; }
  /// What is seen: the scene with its legend, device pixels.
  [[nodiscard]] QImage picture();

 Q_SIGNALS:
  /// A click: the node under the cursor, or kNoNode. `add`: Ctrl or Shift was held.
  void picked(lodestone::NodeId node, bool add);
  /// The node under the resting cursor, or kNoNode; told when it changes.
  void hovered(lodestone::NodeId node);
  /// Point of the ground under the cursor, local metres; told as the cursor moves.
  void pointedAt(double x, double y, double z);

 protected:
  void clicked(const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) override;
  void rested(const QPointF& at) override;
  void left() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct CityContent;
  explicit Viewport(CityContent content, QWidget* parent);
  void setHovered(NodeId node);
  /// Brings the legend up to what is drawn, and into its corner.
  void showLegend();

  CityScene* scene_;
  SceneLegend* legend_;
  NodeId hovered_ = kNoNode;
};

}  // namespace lodestone
