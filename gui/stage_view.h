// The panes of the stage as a widget: titles over them, a line to wipe between two.
#pragma once

#include <QWidget>

#include "gui/scene_widget.h"
#include "gui/view3d/building_scene.h"

class QLabel;

namespace lodestone {

/// The 3D part: what is pointed at.
class StageScene : public SceneWidget {
  Q_OBJECT

 public:
  explicit StageScene(QWidget* parent = nullptr);
  [[nodiscard]] BuildingScene& scene() { return *scene_; }

 Q_SIGNALS:
  /// A click; nothing under it: no value. `add`: Ctrl or Shift was held.
  void picked(const std::optional<lodestone::PickedPart>& part, bool add);
  void hovered(std::uint32_t component);

 protected:
  void clicked(const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) override;
  void rested(const QPointF& at) override;
  void left() override;

 private:
  struct BuildingContent;
  explicit StageScene(BuildingContent content, QWidget* parent);

  BuildingScene* scene_;
};

class WipeLine;

class StageView : public QWidget {
  Q_OBJECT

 public:
  explicit StageView(QWidget* parent = nullptr);

  [[nodiscard]] StageScene& view() { return *view_; }
  [[nodiscard]] BuildingScene& scene() { return view_->scene(); }
  void setLayout(PaneLayout layout, const std::vector<std::size_t>& panes);
  /// The words over a pane.
  void setTitle(std::size_t pane, const QString& title, const QString& detail);
  /// Moves the line of the wipe: 0 at the left, 1 at the right.
  void setWipe(double share);
  /// The whole widget as it looks, the panes included.
  [[nodiscard]] QImage picture();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  StageScene* view_;
  QWidget* header_;
  std::array<QLabel*, BuildingScene::kPanes> titles_{};
  std::vector<QWidget*> partings_;
  WipeLine* line_;
};

/// A vertical line with a grip that is dragged, or moved with the arrow keys.
class WipeLine : public QWidget {
  Q_OBJECT

 public:
  explicit WipeLine(QWidget* parent = nullptr);

 Q_SIGNALS:
  void moved(double share);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] double share() const;
};

}  // namespace lodestone
