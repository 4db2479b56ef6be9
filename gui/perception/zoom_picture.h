// A picture that is drawn at any size.
#pragma once

#include <QImage>
#include <QRectF>
#include <memory>
#include <vector>

class QPainter;

namespace lodestone {

struct Picture;

/// Magnified its pixels stay squares with crisp edges; made smaller it is smooth, from copies of half the
/// size that are made once, on any thread. Never changed once made.
class ZoomPicture {
 public:
  explicit ZoomPicture(QImage image);

  [[nodiscard]] const QImage& image() const { return levels_.front(); }
  [[nodiscard]] QSize size() const { return levels_.front().size(); }
  /// Draws what lies in `cell`, with the picture's pixel (0, 0) at `corner` and `scale` units of the painter
  /// a pixel. Cost: the pixels that are drawn, however large the picture is.
  void draw(QPainter& painter, const QRectF& cell, const QPointF& corner, double scale) const;

 private:
  std::vector<QImage> levels_;  ///< each half of the one before
};

[[nodiscard]] std::shared_ptr<const ZoomPicture> zoomable(const Picture& picture);

}  // namespace lodestone
