// Pictures of one size side by side, zoomed and moved in step.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gui/perception/zoom_picture.h"

namespace lodestone {

/// The wheel zooms about the pointer, a drag moves, a double click fits; + and −, the arrow keys and 0 do the
/// same. Whatever pixel is pointed at is marked in all pictures.
class PictureGrid : public QWidget {
  Q_OBJECT

 public:
  struct Entry {
    QString title;
    QString help;
    std::shared_ptr<const ZoomPicture> picture;  ///< null: not there yet
  };

  explicit PictureGrid(QWidget* parent = nullptr);

  /// Pictures of the same size as before stay zoomed as they are.
  void setPictures(std::vector<Entry> entries);
  [[nodiscard]] const std::vector<Entry>& pictures() const { return entries_; }
  /// What is said of a pixel, in a line below the pictures.
  void setReadout(std::function<QString(const QPoint& pixel)> readout) { readout_ = std::move(readout); }
  /// What can be done, in that line while no pixel is pointed at.
  void setHint(const QString& hint) { hint_ = hint; }
  /// Instead of pictures that are not there.
  void setMessage(const QString& message);
  [[nodiscard]] const QString& message() const { return message_; }

  /// Whole pictures, as large as there is room.
  void fit();
  [[nodiscard]] bool isFitted() const { return scale_ <= 0; }
  /// Units of the widget a pixel.
  [[nodiscard]] double scale() const;
  /// Pixel that is pointed at.
  [[nodiscard]] const std::optional<QPoint>& pointed() const { return pointed_; }
  [[nodiscard]] QString readout() const;
  /// Where a place of the pictures, in pixels, is in the widget.
  [[nodiscard]] QPointF placeOf(std::size_t entry, const QPointF& pixel) const;
  /// Of the picture alone, without its title.
  [[nodiscard]] QRectF cell(std::size_t entry) const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// Another pixel is pointed at, or none.
  void pointedChanged();
  /// A click that did not move anything.
  void picked(const QPoint& pixel);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QSize pictureSize() const;
  [[nodiscard]] int columns() const;
  [[nodiscard]] QRectF frame(std::size_t entry) const;
  [[nodiscard]] double fittedScale() const;
  [[nodiscard]] QPointF centre() const;
  [[nodiscard]] std::optional<std::size_t> entryAt(const QPointF& at) const;
  [[nodiscard]] QPointF pixelAt(std::size_t entry, const QPointF& at) const;
  void zoom(double factor, const QPointF& at);
  void moveBy(const QPointF& units);
  void setCentre(const QPointF& pixel);
  void point(const QPointF& at);
  void paintEntry(QPainter& painter, std::size_t entry) const;

  std::vector<Entry> entries_;
  std::function<QString(const QPoint&)> readout_;
  QString message_;
  QString hint_;
  double scale_ = 0;  ///< 0: fitted
  QPointF centre_;    ///< pixel in the middle of each cell, unless they are fitted
  std::optional<QPoint> pointed_;
  std::optional<QPointF> grabbed_;  ///< where the pointer was last
  bool moved_ = false;
};

}  // namespace lodestone
