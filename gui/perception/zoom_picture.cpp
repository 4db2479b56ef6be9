#include "gui/perception/zoom_picture.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/widgets/picture_image.h"

namespace lodestone {
namespace {

constexpr int kLeastSide = 32;  // pixels; below it nothing is gained by halves

}  // namespace

ZoomPicture::ZoomPicture(QImage image) {
  levels_.push_back(image.convertToFormat(QImage::Format_RGB32));
  while (std::min(levels_.back().width(), levels_.back().height()) >= 2 * kLeastSide) {
    const QSize half = levels_.back().size() / 2;
    levels_.push_back(levels_.back().scaled(half, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  }
}

void ZoomPicture::draw(QPainter& painter, const QRectF& cell, const QPointF& corner, double scale) const {
  const QRectF whole(corner, QSizeF(size()) * scale);
  const QRectF shown = whole.intersected(cell);
  if (shown.isEmpty()) return;
  const double pixels = scale * painter.device()->devicePixelRatioF();  // of the screen, for one of ours
  const auto wanted = static_cast<std::size_t>(std::max(0.0, std::floor(-std::log2(pixels) + 1e-9)));
  const QImage& level = levels_[std::min(wanted, levels_.size() - 1)];
  const double across = level.width() / whole.width();
  const double down = level.height() / whole.height();
  const QRectF source((shown.left() - whole.left()) * across, (shown.top() - whole.top()) * down,
                      shown.width() * across, shown.height() * down);
  painter.save();
  painter.setClipRect(cell, Qt::IntersectClip);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, pixels < 1);
  painter.drawImage(shown, level, source);
  painter.restore();
}

std::shared_ptr<const ZoomPicture> zoomable(const Picture& picture) {
  return std::make_shared<const ZoomPicture>(toImage(picture));
}

}  // namespace lodestone
