#include "gui/simplification/sight_picture.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

namespace lodestone {

SightPicture::SightPicture(std::function<QString(std::uint32_t)> nameOf, QWidget* parent)
    : QWidget(parent), nameOf_(std::move(nameOf)) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

QSize SightPicture::sizeHint() const {
  const int width = fontMetrics().averageCharWidth() * 18;
  return {width, heightForWidth(width)};
}

QSize SightPicture::minimumSizeHint() const {
  const int width = fontMetrics().averageCharWidth() * 7;
  return {width, heightForWidth(width)};
}

void SightPicture::show(std::shared_ptr<const Sighting> sighting, const Sighting* original) {
  if (sighting == sighting_) return;
  sighting_ = std::move(sighting);
  image_ = {};
  if (sighting_ && original) {
    const Picture picture = identityPicture(*sighting_, *original);
    image_ = QImage(picture.rgba.data(), picture.width, picture.height, QImage::Format_RGBA8888).copy();
  }
  update();
}

QRectF SightPicture::area() const {
  const QSizeF size = QSizeF(image_.size()).scaled(this->size(), Qt::KeepAspectRatio);
  return {(width() - size.width()) / 2, (height() - size.height()) / 2, size.width(), size.height()};
}

void SightPicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::Mid));
  if (image_.isNull()) {
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF place = area();
  const QSize pixels = (place.size() * devicePixelRatioF()).toSize();
  painter.drawImage(place, image_.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  painter.drawRect(place.adjusted(0, 0, -1, -1));
}

std::uint32_t SightPicture::whoAt(const QPointF& at) const {
  const QRectF place = area();
  if (image_.isNull() || !place.contains(at)) return kNobody;
  const auto x = static_cast<std::size_t>((at.x() - place.x()) / place.width() * image_.width());
  const auto y = static_cast<std::size_t>((at.y() - place.y()) / place.height() * image_.height());
  const auto width = static_cast<std::size_t>(sighting_->width);
  return x < width && y < static_cast<std::size_t>(sighting_->height) ? sighting_->who[y * width + x]
                                                                      : kNobody;
}

void SightPicture::mousePressEvent(QMouseEvent* event) {
  const std::uint32_t who = whoAt(event->position());
  if (event->button() == Qt::LeftButton && who < kBlocked) Q_EMIT picked(who);
}

bool SightPicture::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || image_.isNull()) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const std::uint32_t who = whoAt(help->pos());
  QToolTip::showText(help->globalPos(),
                     who < kBlocked    ? nameOf_(who)
                     : who == kBlocked ? tr("The building on the stage")
                                       : tr("Each building has a colour of its own; red are those that are "
                                            "not seen past the original, grey is what stands in the way."),
                     this);
  return true;
}

}  // namespace lodestone
