// The dendrogram as a widget: zoom, pan, a cut line to drag, nodes to point at.
#pragma once

#include <QImage>
#include <QWidget>
#include <optional>

#include "gui/city/dendrogram_raster.h"

namespace lodestone {

class Workspace;

/// Wheel zooms along the leaves (with Ctrl: along the weights), drag pans, the cut line can be dragged, a
/// click selects a subtree and a double-click zooms to it. Keys: left and right pan, + and − zoom, up and
/// down move the cut line, Home shows all.
class DendrogramView : public QWidget {
  Q_OBJECT

 public:
  explicit DendrogramView(Workspace& workspace, QWidget* parent = nullptr);

  void showAll();
  void zoomTo(NodeId node);
  /// Weight at which the cut line stands, also while the cut follows the camera.
  [[nodiscard]] double lineWeight() const { return weightOfHeight(lineHeight_); }
  /// Widget position of the cut line's handle and of a node's bar, for tests.
  [[nodiscard]] QPoint linePosition() const;
  [[nodiscard]] QPoint positionOf(NodeId node) const;
  [[nodiscard]] const DendrogramLayout& layoutOfNodes() const { return layout_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Drag { None, Press, Pan, Line };

  void treeChanged();
  void cutChanged();
  void moveLine(double height);
  void zoom(double factor, double centre);
  void zoomHeights(double factor, double centre);
  void pan(double leaves, double heights);
  void clampWindow();
  [[nodiscard]] QRect plotRect() const;
  [[nodiscard]] DendrogramWindow window() const;  ///< in logical pixels of plotRect()
  [[nodiscard]] NodeId nodeAt(const QPointF& position) const;
  [[nodiscard]] bool onLine(const QPointF& position) const;

  void paintTree(QPainter& painter);
  void paintAxes(QPainter& painter) const;
  void paintNode(QPainter& painter, NodeId node, const QColor& colour) const;
  void paintLine(QPainter& painter) const;
  void paintEmpty(QPainter& painter) const;

  Workspace& workspace_;
  DendrogramLayout layout_;
  DendrogramRaster raster_;
  QImage picture_;
  std::vector<std::uint8_t> drawn_;
  std::size_t clusters_ = 0;
  double left_ = 0;
  double right_ = 1;
  double bottom_ = kLeafHeight;
  double top_ = 1;
  double lineHeight_ = 0;
  Drag drag_ = Drag::None;
  QPointF dragFrom_;
};

/// "12", "3.4k", "1.2M".
[[nodiscard]] QString shortNumber(double value);

}  // namespace lodestone
