// The panes of the stage as a widget: titles over them, a line to wipe between two.
#pragma once

#include <QWidget>

#include "gui/surfaces/scene_widget.h"
#include "gui/view3d/building_scene.h"

class QLabel;

namespace lodestone {

/// Takes clicks and drags of the left button before the camera and the selection get them. Device pixels.
class StageTool {
 public:
  StageTool() = default;
  virtual ~StageTool() = default;
  StageTool(const StageTool&) = delete;
  StageTool& operator=(const StageTool&) = delete;
  /// False: not for the tool.
  virtual bool click(const QPointF& at) = 0;
  virtual bool grab(const QPointF& at) = 0;
  virtual void pull(const QPointF& at) = 0;
  virtual void release() = 0;
  /// Escape; false: there is nothing to give up.
  virtual bool cancel() = 0;
};

/// The 3D part: what is pointed at.
class StageScene : public SceneWidget {
  Q_OBJECT

 public:
  explicit StageScene(QWidget* parent = nullptr);
  [[nodiscard]] BuildingScene& scene() { return *scene_; }
  /// Asked first; null: none.
  void setTool(StageTool* tool) { tool_ = tool; }

 Q_SIGNALS:
  /// A click; nothing under it: no value. `add`: Ctrl or Shift was held.
  void picked(const std::optional<lodestone::PickedPart>& part, bool add);
  /// A click on a building around, by its place in the surroundings.
  void targetPicked(std::size_t target);
  void hovered(std::uint32_t component);

 protected:
  void clicked(const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) override;
  void rested(const QPointF& at) override;
  void left() override;
  bool grabbed(const QPointF& at) override { return tool_ && tool_->grab(at); }
  void pulled(const QPointF& at) override { tool_->pull(at); }
  void released() override { tool_->release(); }
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct BuildingContent;
  explicit StageScene(BuildingContent content, QWidget* parent);

  BuildingScene* scene_;
  StageTool* tool_ = nullptr;
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
