// What somebody sees from the viewpoint past one model, each building in a colour of its own.
#pragma once

#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>

#include "algorithms/rendering/visibility.h"

namespace lodestone {

class SightPicture : public QWidget {
  Q_OBJECT

 public:
  /// `nameOf` names a target, for the tooltip.
  explicit SightPicture(std::function<QString(std::uint32_t)> nameOf, QWidget* parent = nullptr);

  /// Null: nothing is seen yet. Those that are not seen past the original are red.
  void show(std::shared_ptr<const Sighting> sighting, const Sighting* original);
  [[nodiscard]] const QImage& image() const { return image_; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return width / 2; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void picked(std::uint32_t target);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QRectF area() const;
  /// kNobody beside the picture.
  [[nodiscard]] std::uint32_t whoAt(const QPointF& at) const;

  std::function<QString(std::uint32_t)> nameOf_;
  std::shared_ptr<const Sighting> sighting_;
  QImage image_;
};

}  // namespace lodestone
