#include "gui/perception/picture_grid.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "gui/widgets/colours.h"

namespace lodestone {
namespace {

constexpr double kGap = 6;         // between pictures
constexpr double kStep = 1.25;     // of the zoom
constexpr double kMostScale = 64;  // units a pixel
constexpr double kKeyMove = 48;    // units
constexpr double kMarkedFrom = 3;  // units a pixel from which the one that is pointed at is framed
constexpr double kClickReach = 3;  // units a click may move

}  // namespace

PictureGrid::PictureGrid(QWidget* parent)
    : QWidget(parent), hint_(tr("Wheel: zoom. Drag: move. Double-click: whole picture.")) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize PictureGrid::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 100, fontMetrics().height() * 16};
}

QSize PictureGrid::minimumSizeHint() const {
  return {fontMetrics().averageCharWidth() * 40, fontMetrics().height() * 8};
}

void PictureGrid::setPictures(std::vector<Entry> entries) {
  const QSize before = pictureSize();
  entries_ = std::move(entries);
  if (pictureSize() != before) fit();
  if (pointed_ && !QRect(QPoint(), pictureSize()).contains(*pointed_)) pointed_.reset();
  Q_EMIT pointedChanged();
  update();
}

void PictureGrid::setMessage(const QString& message) {
  if (message == message_) return;
  message_ = message;
  setAccessibleDescription(message);
  update();
}

QSize PictureGrid::pictureSize() const {
  for (const Entry& entry : entries_) {
    if (entry.picture) return entry.picture->size();
  }
  return {};
}

/// As many beside each other as make the pictures largest.
int PictureGrid::columns() const {
  const int count = std::max(1, static_cast<int>(entries_.size()));
  const QSizeF picture = pictureSize().isEmpty() ? QSizeF(1, 1) : QSizeF(pictureSize());
  int best = count;
  double most = 0;
  for (int columns = count; columns >= 1; --columns) {
    const int rows = (count + columns - 1) / columns;
    const double wide = (width() - kGap * (columns - 1)) / columns / picture.width();
    const double high =
        ((height() - fontMetrics().height() * 1.3) / rows - fontMetrics().height() * 1.4) / picture.height();
    const double size = std::min(wide, high);
    if (size <= most * 1.02) continue;
    most = size;
    best = columns;
  }
  return best;
}

QRectF PictureGrid::frame(std::size_t entry) const {
  const int across = columns();
  const int down = (std::max(1, static_cast<int>(entries_.size())) + across - 1) / across;
  const double below = fontMetrics().height() * 1.3;  // the line that tells of the pixel
  const double wide = (width() - kGap * (across - 1)) / across;
  const double high = (height() - below) / down;
  const auto column = static_cast<double>(entry % static_cast<std::size_t>(across));
  const auto row = static_cast<double>(entry / static_cast<std::size_t>(across));
  return {column * (wide + kGap), row * high, wide, high};
}

QRectF PictureGrid::cell(std::size_t entry) const {
  return frame(entry).adjusted(0, fontMetrics().height() * 1.3, 0, 0);
}

double PictureGrid::fittedScale() const {
  const QSize size = pictureSize();
  if (size.isEmpty()) return 1;
  const QRectF area = cell(0);
  return std::max(1e-3, std::min(area.width() / size.width(), area.height() / size.height()));
}

double PictureGrid::scale() const {
  return isFitted() ? fittedScale() : scale_;
}

QPointF PictureGrid::centre() const {
  return isFitted() ? QPointF(pictureSize().width(), pictureSize().height()) / 2 : centre_;
}

QPointF PictureGrid::placeOf(std::size_t entry, const QPointF& pixel) const {
  return cell(entry).center() + (pixel - centre()) * scale();
}

QPointF PictureGrid::pixelAt(std::size_t entry, const QPointF& at) const {
  return centre() + (at - cell(entry).center()) / scale();
}

std::optional<std::size_t> PictureGrid::entryAt(const QPointF& at) const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].picture && cell(i).contains(at)) return i;
  }
  return {};
}

void PictureGrid::fit() {
  scale_ = 0;
  update();
}

void PictureGrid::zoom(double factor, const QPointF& at) {
  const auto entry = entryAt(at);
  if (!entry) return;
  const QPointF pixel = pixelAt(*entry, at);
  const double next = std::min(scale() * factor, kMostScale);
  if (next <= fittedScale()) return fit();
  scale_ = next;
  setCentre(pixel - (at - cell(*entry).center()) / scale_);
}

void PictureGrid::moveBy(const QPointF& units) {
  if (!isFitted()) setCentre(centre_ - units / scale_);
}

/// The middle of a cell always shows the picture.
void PictureGrid::setCentre(const QPointF& pixel) {
  centre_ = {std::clamp(pixel.x(), 0.0, static_cast<double>(pictureSize().width())),
             std::clamp(pixel.y(), 0.0, static_cast<double>(pictureSize().height()))};
  update();
}

void PictureGrid::point(const QPointF& at) {
  std::optional<QPoint> pixel;
  if (const auto entry = entryAt(at)) {
    const QPointF place = pixelAt(*entry, at);
    const QPoint whole(static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y())));
    if (QRect(QPoint(), pictureSize()).contains(whole)) pixel = whole;
  }
  if (pixel == pointed_) return;
  pointed_ = pixel;
  Q_EMIT pointedChanged();
  update();
}

QString PictureGrid::readout() const {
  return pointed_ && readout_ ? readout_(*pointed_) : QString();
}

void PictureGrid::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (pictureSize().isEmpty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, message_);
  } else {
    for (std::size_t i = 0; i < entries_.size(); ++i) paintEntry(painter, i);
    const QString said = readout();
    painter.setPen(palette().color(said.isEmpty() ? QPalette::PlaceholderText : QPalette::Text));
    const QString text = said.isEmpty() ? hint_ : said;
    const QRect line(0, height() - fontMetrics().height() - 1, width(), fontMetrics().height() + 1);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text, Qt::ElideRight, width()));
  }
  if (hasFocus()) {
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void PictureGrid::paintEntry(QPainter& painter, std::size_t i) const {
  const QRectF area = cell(i);
  painter.setPen(palette().color(QPalette::Text));
  const QRectF title(area.left(), frame(i).top(), area.width(), area.top() - frame(i).top());
  painter.drawText(
      title, Qt::AlignCenter,
      fontMetrics().elidedText(entries_[i].title, Qt::ElideRight, static_cast<int>(area.width())));
  painter.fillRect(area, mixed(palette().color(QPalette::Window), palette().color(QPalette::Text), 0.1));
  if (!entries_[i].picture) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap, entries_[i].help);
    return;
  }
  entries_[i].picture->draw(painter, area, placeOf(i, QPointF(0, 0)), scale());
  if (!pointed_) return;
  painter.save();
  painter.setClipRect(area);
  const QPointF corner = placeOf(i, *pointed_);
  const QRectF mark = scale() >= kMarkedFrom
                          ? QRectF(corner, QSizeF(scale(), scale()))
                          : QRectF(corner.x() - 4, corner.y() - 4, scale() + 8, scale() + 8);
  painter.setPen(QPen(Qt::black, 3));
  painter.drawRect(mark);
  painter.setPen(QPen(Qt::white, 1));
  painter.drawRect(mark);
  painter.restore();
}

void PictureGrid::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(kStep, event->angleDelta().y() / 120.0), event->position());
  point(event->position());
  event->accept();
}

void PictureGrid::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton) return;
  grabbed_ = event->position();
  moved_ = false;
}

void PictureGrid::mouseMoveEvent(QMouseEvent* event) {
  if (grabbed_ && (event->buttons() & (Qt::LeftButton | Qt::MiddleButton))) {
    const QPointF by = event->position() - *grabbed_;
    if (moved_ || by.manhattanLength() > kClickReach) {
      moved_ = true;
      moveBy(by);
      grabbed_ = event->position();
    }
  }
  point(event->position());
}

void PictureGrid::mouseReleaseEvent(QMouseEvent* event) {
  const bool click = grabbed_ && !moved_ && event->button() == Qt::LeftButton;
  grabbed_.reset();
  if (click && pointed_) Q_EMIT picked(*pointed_);
}

void PictureGrid::mouseDoubleClickEvent(QMouseEvent*) {
  fit();
}

void PictureGrid::leaveEvent(QEvent*) {
  if (!pointed_) return;
  pointed_.reset();
  Q_EMIT pointedChanged();
  update();
}

void PictureGrid::keyPressEvent(QKeyEvent* event) {
  const QPointF middle = cell(0).center();
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(kStep, middle);
    case Qt::Key_Minus:
      return zoom(1 / kStep, middle);
    case Qt::Key_0:
    case Qt::Key_Home:
      return fit();
    case Qt::Key_Left:
      return moveBy({kKeyMove, 0});
    case Qt::Key_Right:
      return moveBy({-kKeyMove, 0});
    case Qt::Key_Up:
      return moveBy({0, kKeyMove});
    case Qt::Key_Down:
      return moveBy({0, -kKeyMove});
    default:
      QWidget::keyPressEvent(event);
  }
}

bool PictureGrid::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QString text;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const QRectF title(frame(i).topLeft(), QSizeF(frame(i).width(), cell(i).top() - frame(i).top()));
    if (title.contains(help->pos())) text = entries_[i].help;
  }
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

}  // namespace lodestone
