#include "gui/perception/viewpoint_strip.h"

#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>
#include <cmath>
#include <numbers>

namespace lodestone {
namespace {

QIcon emptyFrame(const QSize& size, const QPalette& palette) {
  QPixmap picture(size);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setPen(QPen(palette.color(QPalette::Mid), 1, Qt::DashLine));
  painter.drawRect(QRect(QPoint(), size).adjusted(1, 1, -2, -2));
  return picture;
}

/// Chosen it has a frame, and is not tinted as icons are.
QIcon framed(const QPixmap& picture, const QPalette& palette) {
  QIcon icon(picture);
  QPixmap chosen = picture;
  QPainter painter(&chosen);
  const int wide = std::max(2, picture.width() / 12);
  painter.setPen(QPen(palette.color(QPalette::Highlight), wide, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(QRectF(picture.rect()).adjusted(wide / 2.0, wide / 2.0, -wide / 2.0, -wide / 2.0));
  painter.end();
  icon.addPixmap(chosen, QIcon::Selected);
  return icon;
}

}  // namespace

QString directionText(const Camera& camera) {
  const Vec3 from = camera.eye - camera.target;
  const double away = from.norm();
  if (away == 0) return {};
  const double above = std::asin(std::clamp(from.z() / away, -1.0, 1.0)) * 180 / std::numbers::pi;
  const int degrees = static_cast<int>(std::lround(std::abs(above)));
  if (degrees >= 88)
    return above > 0 ? ViewpointStrip::tr("from straight above") : ViewpointStrip::tr("from straight below");
  static const char* const kNames[] = {
      QT_TRANSLATE_NOOP("ViewpointStrip", "north"), QT_TRANSLATE_NOOP("ViewpointStrip", "north-east"),
      QT_TRANSLATE_NOOP("ViewpointStrip", "east"),  QT_TRANSLATE_NOOP("ViewpointStrip", "south-east"),
      QT_TRANSLATE_NOOP("ViewpointStrip", "south"), QT_TRANSLATE_NOOP("ViewpointStrip", "south-west"),
      QT_TRANSLATE_NOOP("ViewpointStrip", "west"),  QT_TRANSLATE_NOOP("ViewpointStrip", "north-west")};
  const double heading = std::atan2(from.x(), from.y()) / (std::numbers::pi / 4);
  const auto eighth = static_cast<std::size_t>((std::lround(heading) + 8) % 8);
  const QString side = ViewpointStrip::tr(kNames[eighth]);
  if (degrees == 0) return ViewpointStrip::tr("from the %1").arg(side);
  return (above > 0 ? ViewpointStrip::tr("from the %1, %2° above")
                    : ViewpointStrip::tr("from the %1, %2° below"))
      .arg(side)
      .arg(degrees);
}

ViewpointStrip::ViewpointStrip(QWidget* parent) : QListWidget(parent) {
  setObjectName(QStringLiteral("viewpoints"));
  setAccessibleName(tr("Viewpoints"));
  setWhatsThis(
      tr("Where the model is looked at from. The chosen viewpoint is the one whose pictures are shown."));
  setViewMode(QListView::IconMode);
  setFlow(QListView::LeftToRight);
  setWrapping(false);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(true);
  setSpacing(1);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const int side = fontMetrics().height() * 3;
  setIconSize({side, side});
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0) Q_EMIT chosen(static_cast<std::size_t>(row));
  });
}

QSize ViewpointStrip::sizeHint() const {
  const int bar = horizontalScrollBar()->sizeHint().height();
  return {iconSize().width() * 12, iconSize().height() + fontMetrics().height() + 14 + bar};
}

void ViewpointStrip::setViewpoints(const std::vector<Camera>& cameras) {
  const QSignalBlocker quiet(this);
  const int row = currentRow();
  clear();
  const QIcon empty = emptyFrame(iconSize() * devicePixelRatioF(), palette());
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    auto* item = new QListWidgetItem(empty, QString::number(i + 1), this);
    const QString where = tr("Viewpoint %1: %2").arg(i + 1).arg(directionText(cameras[i]));
    item->setToolTip(where);
    item->setData(Qt::AccessibleTextRole, where);
  }
  if (row >= 0 && row < count()) setCurrentRow(row);
}

void ViewpointStrip::setPicture(std::size_t view, const QImage& picture) {
  if (view < viewCount())
    item(static_cast<int>(view))->setIcon(framed(QPixmap::fromImage(picture), palette()));
}

void ViewpointStrip::choose(std::size_t view) {
  const QSignalBlocker quiet(this);
  if (view >= viewCount()) return setCurrentRow(-1);
  setCurrentRow(static_cast<int>(view));
}

}  // namespace lodestone
