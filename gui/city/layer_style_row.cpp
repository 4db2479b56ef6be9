#include "gui/city/layer_style_row.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include "gui/widgets/colours.h"

namespace lodestone {
namespace {

constexpr int kPercent = 100;

QColor toColour(const Rgb& rgb) {
  return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
}

/// A filled square; one with a stroke across it where there is no colour of its own.
QIcon swatch(const std::optional<Rgb>& colour, const QWidget& widget) {
  const int side = widget.fontMetrics().height();
  QPixmap pixmap(QSize(side, side) * widget.devicePixelRatioF());
  pixmap.setDevicePixelRatio(widget.devicePixelRatioF());
  pixmap.fill(colour ? toColour(*colour) : widget.palette().color(QPalette::Base));
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(mixed(widget.palette().color(QPalette::Text), widget.palette().color(QPalette::Base), 0.4));
  painter.drawRect(QRectF(0.5, 0.5, side - 1.0, side - 1.0));
  if (!colour) painter.drawLine(QPointF(1, side - 1.0), QPointF(side - 1.0, 1));
  return pixmap;
}

}  // namespace

LayerStyleRow::LayerStyleRow(QWidget* parent)
    : QWidget(parent), colour_(new QToolButton(this)), opacity_(new QSlider(Qt::Horizontal, this)) {
  colour_->setObjectName(QStringLiteral("layerColour"));
  colour_->setPopupMode(QToolButton::MenuButtonPopup);
  colour_->setFocusPolicy(Qt::StrongFocus);
  colour_->setToolTip(tr("Colour of the chosen layer"));
  colour_->setAccessibleName(colour_->toolTip());
  auto* menu = new QMenu(colour_);
  menu->addAction(tr("&Choose…"), this, &LayerStyleRow::chooseColour);
  menu->addAction(tr("Colour of the &theme"), this, [this] { setColour({}); });
  colour_->setMenu(menu);
  opacity_->setObjectName(QStringLiteral("layerOpacity"));
  opacity_->setRange(0, kPercent);
  opacity_->setToolTip(tr("Opacity of the chosen layer, over the ground"));
  opacity_->setAccessibleName(opacity_->toolTip());
  auto* label = new QLabel(tr("Opacity"), this);
  label->setBuddy(opacity_);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(colour_);
  layout->addWidget(label);
  layout->addWidget(opacity_, 1);
  connect(colour_, &QToolButton::clicked, this, &LayerStyleRow::chooseColour);
  connect(opacity_, &QSlider::valueChanged, this, [this](int percent) {
    style_.opacity = static_cast<float>(percent) / kPercent;
    Q_EMIT edited(style_);
  });
  show(LayerStyle{});
}

void LayerStyleRow::show(const LayerStyle& style) {
  style_ = style;
  const QSignalBlocker quiet(opacity_);
  opacity_->setValue(qRound(style.opacity * kPercent));
  showColour();
}

void LayerStyleRow::showColour() {
  colour_->setIcon(swatch(style_.colour, *this));
}

void LayerStyleRow::setColour(const std::optional<Rgb>& colour) {
  style_.colour = colour;
  showColour();
  Q_EMIT edited(style_);
}

void LayerStyleRow::chooseColour() {
  const QColor now = style_.colour ? toColour(*style_.colour) : palette().color(QPalette::Mid);
  const QColor chosen = QColorDialog::getColor(now, this, tr("Colour of the layer"));
  if (chosen.isValid()) setColour(Rgb{chosen.redF(), chosen.greenF(), chosen.blueF()});
}

}  // namespace lodestone
