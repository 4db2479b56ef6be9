#include "gui/city/level_strip.h"

#include <QEvent>
#include <QFocusEvent>
#include <QLocale>
#include <QPainter>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <cmath>

#include "gui/widgets/colours.h"

namespace lodestone {
namespace {

enum Role { Picture = Qt::UserRole, Share, Lines };

constexpr int kMargin = 5;         // around a card's contents, pixels
constexpr int kTextLines = 3;      // name; polygons; error and distance
constexpr int kPictureChars = 27;  // width of a card's picture

int textHeight(const QFontMetrics& metrics) {
  return kTextLines * metrics.height() + kMargin;
}

/// Cards are as high as the strip: what the text leaves is the picture's.
class CardDelegate : public QStyledItemDelegate {
 public:
  explicit CardDelegate(LevelStrip* strip) : QStyledItemDelegate(strip), strip_(*strip) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    const int least = 3 * option.fontMetrics.height() + textHeight(option.fontMetrics) + 2 * kMargin;
    return {option.fontMetrics.averageCharWidth() * kPictureChars + 2 * kMargin,
            std::max(least, strip_.viewport()->height() - 2 * strip_.spacing())};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRectF card = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5);
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    const QColor accent = option.palette.color(QPalette::Highlight);
    const QColor plain =
        mixed(option.palette.color(QPalette::Text), option.palette.color(QPalette::Base), 0.75);
    painter->setPen(QPen(chosen ? accent : plain, chosen ? 2.5 : 1));
    painter->setBrush(option.palette.color(QPalette::Base));
    painter->drawRoundedRect(card, 5, 5);
    const QRect picture =
        option.rect.adjusted(kMargin, kMargin, -kMargin, -kMargin - textHeight(option.fontMetrics));
    paintPicture(*painter, picture, index, option.palette);
    paintText(*painter, picture, index, option);
    painter->restore();
  }

 private:
  static void paintPicture(QPainter& painter, const QRect& at, const QModelIndex& index,
                           const QPalette& palette) {
    const auto picture = index.data(Picture).value<QImage>();
    if (!picture.isNull()) {
      painter.setRenderHint(QPainter::SmoothPixmapTransform);
      const QSizeF shown = QSizeF(at.size()).scaled(picture.size(), Qt::KeepAspectRatio);
      QRectF middle(QPointF(), shown);
      middle.moveCenter(QRectF(picture.rect()).center());
      painter.drawImage(at, picture, middle);
    } else {
      painter.fillRect(at, mixed(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.06));
    }
  }

  static void paintText(QPainter& painter, const QRect& picture, const QModelIndex& index,
                        const QStyleOptionViewItem& option) {
    const int height = option.fontMetrics.height();
    QRect line(picture.left(), picture.bottom() + kMargin, picture.width(), height);
    QFont bold = option.font;
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(option.palette.color(QPalette::Text));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(bold).elidedText(index.data().toString(), Qt::ElideRight, line.width()));
    painter.setFont(option.font);
    line.translate(0, height);
    QRectF bar(line);
    bar.setWidth(bar.width() * index.data(Share).toDouble());
    QColor accent = option.palette.color(QPalette::Highlight);
    accent.setAlphaF(0.25F);
    painter.fillRect(bar, accent);
    for (const QString& text : index.data(Lines).toStringList()) {
      painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                       option.fontMetrics.elidedText(text, Qt::ElideRight, line.width()));
      line.translate(0, height);
    }
  }

  LevelStrip& strip_;
};

/// With ε = 0 a level takes over nowhere.
QString distanceOf(const LodLevel& level, const QString& from, const QString& never) {
  return std::isfinite(level.switchDistance) ? from.arg(QLocale().toString(level.switchDistance, 'f', 0))
                                             : never;
}

QStringList linesOf(const LodLevel& level, double share) {
  const QLocale locale;
  return {LevelStrip::tr("%1 polygons, %2%")
              .arg(locale.toString(static_cast<qulonglong>(level.faces.polygons)),
                   locale.toString(100 * share, 'f', 1)),
          LevelStrip::tr("%1 m off, %2")
              .arg(locale.toString(level.error, 'f', 1),
                   distanceOf(level, LevelStrip::tr("from %1 m"), LevelStrip::tr("never drawn")))};
}

QString helpOf(const LodLevel& level) {
  const QLocale locale;
  return LevelStrip::tr(
             "<p><b>%1</b></p><p>Method: %2<br>Objects: %L3<br>Polygons: %L4<br>Triangles: %L5<br>Greatest "
             "error: %6 m<br>%7</p>")
      .arg(QString::fromStdString(level.name).toHtmlEscaped(), QString::fromStdString(level.method))
      .arg(level.objectCount)
      .arg(level.faces.polygons)
      .arg(level.faces.triangles)
      .arg(locale.toString(level.error, 'f', 2),
           distanceOf(level, LevelStrip::tr("Takes over from %1 m away"),
                      LevelStrip::tr("Takes over nowhere: ε is 0")));
}

}  // namespace

LevelStrip::LevelStrip(QWidget* parent) : QListView(parent), model_(new QStandardItemModel(this)) {
  setObjectName(QStringLiteral("levelStrip"));
  setAccessibleName(tr("Levels of the chain"));
  setModel(model_);
  setItemDelegate(new CardDelegate(this));
  setFlow(LeftToRight);
  setWrapping(false);
  setUniformItemSizes(true);
  setSpacing(3);
  setMouseTracking(true);
  setFrameShape(NoFrame);
  setEditTriggers(NoEditTriggers);
  setHorizontalScrollMode(ScrollPerPixel);
  setVerticalScrollMode(ScrollPerPixel);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setTabKeyNavigation(false);
  viewport()->setAutoFillBackground(false);
  const auto choose = [this](const QModelIndex& index) { Q_EMIT chosen(index.row()); };
  connect(this, &QAbstractItemView::clicked, this, choose);  // again, when something else is drawn by now
  connect(this, &QAbstractItemView::activated, this, choose);
}

QSize LevelStrip::pictureSize() const {
  const int width = fontMetrics().averageCharWidth() * kPictureChars;
  return {width, width * 9 / 16};
}

QSize LevelStrip::sizeHint() const {
  const QSize picture = pictureSize();
  return {(picture.width() + 2 * kMargin) * 4, picture.height() + textHeight(fontMetrics()) + 2 * kMargin +
                                                   horizontalScrollBar()->sizeHint().height()};
}

void LevelStrip::resizeEvent(QResizeEvent* event) {
  QListView::resizeEvent(event);
  scheduleDelayedItemsLayout();
}

void LevelStrip::setLevels(const std::vector<LodLevel>& levels) {
  const QScopedValueRollback quiet(telling_, false);
  model_->clear();
  for (const LodLevel& level : levels) {
    const double part = share(level.faces, levels.front().faces);
    auto* item = new QStandardItem(QString::fromStdString(level.name));
    item->setData(std::min(part, 1.0), Share);
    item->setData(linesOf(level, part), Lines);
    item->setToolTip(helpOf(level));
    item->setData(item->text() + QStringLiteral(", ") + linesOf(level, part).join(QStringLiteral(", ")),
                  Qt::AccessibleTextRole);
    model_->appendRow(item);
  }
}

void LevelStrip::setPictures(const std::vector<QImage>& pictures) {
  for (int row = 0; row < model_->rowCount() && row < static_cast<int>(pictures.size()); ++row)
    model_->item(row)->setData(pictures[static_cast<std::size_t>(row)], Picture);
}

void LevelStrip::setShown(int level) {
  const QScopedValueRollback quiet(telling_, false);
  if (level == currentIndex().row()) return;
  if (level < 0) {
    clearSelection();
    setCurrentIndex({});
  } else {
    setCurrentIndex(model_->index(level, 0));
  }
}

void LevelStrip::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  QListView::currentChanged(current, previous);
  if (telling_ && current.isValid()) Q_EMIT chosen(current.row());
}

void LevelStrip::focusInEvent(QFocusEvent* event) {
  const bool none = !currentIndex().isValid();
  const QScopedValueRollback quiet(telling_, false);
  QListView::focusInEvent(event);  // makes the first card the current one where there is none
  if (none) setCurrentIndex({});
}

void LevelStrip::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange) scheduleDelayedItemsLayout();
  QListView::changeEvent(event);
}

}  // namespace lodestone
