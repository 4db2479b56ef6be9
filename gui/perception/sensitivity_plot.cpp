#include "gui/perception/sensitivity_plot.h"

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algorithms/perception/contrast_sensitivity.h"
#include "algorithms/perception/hvs_filter.h"
#include "gui/widgets/colours.h"

namespace lodestone {
namespace {

constexpr double kLeast = 0.1, kMost = 100;  // cycles per degree
constexpr int kSteps = 240;
constexpr double kReach = 9;  // units from a point that still mean it

QColor straightColour() {
  return {0xe6, 0x9f, 0x00};
}
QColor diagonalColour() {
  return {0x56, 0x9f, 0xd0};
}

std::array<std::pair<QColor, QString>, 2> legend() {
  return {std::pair(straightColour(), SensitivityPlot::tr("straight")),
          std::pair(diagonalColour(), SensitivityPlot::tr("diagonal"))};
}

double entryWidth(const QString& text, const QFontMetrics& metrics) {
  return metrics.horizontalAdvance(text) + 1.7 * metrics.height();
}

}  // namespace

SensitivityPlot::SensitivityPlot(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Contrast sensitivity"));
  setWhatsThis(tr(
      "How well the eye sees contrast by how fine it is: A(f) = 2.6 (0.0192 + c f) exp(−(c f)^1.1) over its "
      "largest value (Mannos and Sakrison 1974; Du, Zhu and Zhao, Eq. (1)). Below the peak the weight stays "
      "1. Points are the bands of the wavelet transform on the display of the parameters: 1 is the finest. "
      "What lies low is filtered away."));
  show(options_);
}

QSize SensitivityPlot::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 44, fontMetrics().height() * 11};
}

QSize SensitivityPlot::minimumSizeHint() const {
  double legendWidth = fontMetrics().horizontalAdvance(tr("weight")) + fontMetrics().height();
  for (const auto& [colour, text] : legend()) legendWidth += entryWidth(text, fontMetrics());
  return {static_cast<int>(std::ceil(legendWidth)), fontMetrics().height() * 7};
}

void SensitivityPlot::show(const PerceiveOptions& options) {
  options_ = options;
  bands_.clear();
  for (const bool diagonal : {false, true}) {
    for (int level = 1; level <= kWaveletLevels; ++level) {
      bands_.push_back({level, diagonal, bandFrequency(level, diagonal, options.pixelsPerDegree()),
                        bandWeight(level, diagonal, options.pixelsPerDegree(), options.csf)});
    }
  }
  update();
}

QRectF SensitivityPlot::plot() const {
  const int line = fontMetrics().height();
  const int left = fontMetrics().horizontalAdvance(QStringLiteral("0.5")) + line;
  return QRectF(rect()).adjusted(left, 2.8 * line, -line / 2, -2.3 * line);
}

QPointF SensitivityPlot::placeOf(double frequency, double weight) const {
  const QRectF area = plot();
  const double share = std::log(std::clamp(frequency, kLeast, kMost) / kLeast) / std::log(kMost / kLeast);
  return {area.left() + share * area.width(), area.bottom() - weight * area.height()};
}

void SensitivityPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintAxes(painter);
  paintCurve(painter);
  paintBands(painter);
}

void SensitivityPlot::paintAxes(QPainter& painter) const {
  const QRectF area = plot();
  const int line = fontMetrics().height();
  const QColor faint = mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.2);
  for (const double weight : {0.0, 0.5, 1.0}) {
    const QPointF left = placeOf(kLeast, weight);
    painter.setPen(faint);
    painter.drawLine(left, placeOf(kMost, weight));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(0, left.y() - line, left.x() - 5, 2 * line), Qt::AlignRight | Qt::AlignVCenter,
                     QLocale().toString(weight));
  }
  for (const double frequency : {0.1, 1.0, 10.0, 100.0}) {
    const QPointF foot = placeOf(frequency, 0);
    painter.setPen(faint);
    painter.drawLine(foot, QPointF(foot.x(), area.top()));
    painter.setPen(palette().color(QPalette::Text));
    const QRectF words(foot.x() - 2 * line, foot.y() + 3, 4 * line, line);
    painter.drawText(words.translated(std::min(0.0, width() - words.center().x() - line), 0), Qt::AlignCenter,
                     QLocale().toString(frequency));
  }
  const QString pixels = QLocale().toString(options_.pixelsPerDegree(), 'f', 1);
  for (const QString& text :
       {tr("cycles per degree; %1 pixels per degree").arg(pixels), tr("cycles per degree"), tr("cycles/°")}) {
    if (fontMetrics().horizontalAdvance(text) > width()) continue;
    painter.drawText(QRectF(0, area.bottom() + 1.15 * line, width(), line), Qt::AlignCenter, text);
    break;
  }
  painter.drawText(QPointF(2, line * 1.1), tr("weight"));
  double x = fontMetrics().horizontalAdvance(tr("weight")) + line;
  for (const auto& [colour, text] : legend()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(QPointF(x + line * 0.3, line * 0.75), 4, 4);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QPointF(x + line * 0.8, line * 1.1), text);
    x += entryWidth(text, fontMetrics());
  }
}

/// A(f) itself, and the plateau of the weights below its peak.
void SensitivityPlot::paintCurve(QPainter& painter) const {
  const double peak = peakFrequency(options_.csf);
  const double most = contrastSensitivity(peak, options_.csf);
  QPainterPath curve;
  for (int i = 0; i <= kSteps; ++i) {
    const double frequency = kLeast * std::pow(kMost / kLeast, static_cast<double>(i) / kSteps);
    const QPointF at = placeOf(frequency, contrastSensitivity(frequency, options_.csf) / most);
    i == 0 ? curve.moveTo(at) : curve.lineTo(at);
  }
  const QColor ink = palette().color(QPalette::Text);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(ink, 1.6));
  painter.drawPath(curve);
  painter.setPen(QPen(ink, 1.6, Qt::DashLine));
  painter.drawLine(placeOf(kLeast, 1), placeOf(peak, 1));
}

void SensitivityPlot::paintBands(QPainter& painter) const {
  const int line = fontMetrics().height();
  for (const Band& band : bands_) {
    const QPointF at = placeOf(band.frequency, band.weight);
    painter.setPen(QPen(palette().color(QPalette::Base), 1.2));
    painter.setBrush(band.diagonal ? diagonalColour() : straightColour());
    painter.drawEllipse(at, 4.5, 4.5);
    painter.setPen(palette().color(QPalette::Text));
    const double over = band.diagonal ? line * 0.35 : -line * 1.15;
    painter.drawText(QRectF(at.x() - line, at.y() + over, 2 * line, line * 0.9), Qt::AlignCenter,
                     QString::number(band.level));
  }
}

bool SensitivityPlot::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QString text;
  double nearest = kReach;
  for (const Band& band : bands_) {
    const QPointF off = placeOf(band.frequency, band.weight) - QPointF(help->pos());
    const double away = std::hypot(off.x(), off.y());
    if (away > nearest) continue;
    nearest = away;
    text = (band.diagonal ? tr("Band %1, diagonal: %2 cycles per degree, weight %3")
                          : tr("Band %1, straight: %2 cycles per degree, weight %3"))
               .arg(band.level)
               .arg(QLocale().toString(band.frequency, 'f', 2), QLocale().toString(band.weight, 'f', 3));
  }
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

}  // namespace lodestone
