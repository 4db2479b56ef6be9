#include "gui/simplification/auto_curve.h"

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/widgets/colours.h"
#include "gui/widgets/metres.h"

namespace lodestone {
namespace {

constexpr double kLeast = 1, kMost = 8;  // values of a that are tried
constexpr double kNoise = 1e-6;          // metres
constexpr double kReach = 18;            // pixels from a value that still mean it

QColor distanceColour() {
  return {0x56, 0x9f, 0xd0};
}
QColor gapColour() {
  return {0xe6, 0x9f, 0x00};
}

}  // namespace

AutoCurve::AutoCurve(Stage& stage, QWidget* parent) : QWidget(parent), stage_(stage) {
  setObjectName(QStringLiteral("autoCurve"));
  setMinimumHeight(fontMetrics().height() * 6);
  setWhatsThis(
      tr("With “Find a”, values from 1 to 8 are tried. The one with the smallest sum of widest gap and "
         "Hausdorff distance is taken; of equal ones that with fewer lost contacts."));
  for (const auto change : {&Stage::opening, &Stage::opened, &Stage::closed, &Stage::optionsChanged})
    connect(&stage_, change, this, qOverload<>(&QWidget::update));
  connect(&stage_, &Stage::levelChanged, this, qOverload<>(&QWidget::update));
}

QSize AutoCurve::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 50, fontMetrics().height() * 12};
}

const std::vector<AutoTrial>& AutoCurve::trials() const {
  static const std::vector<AutoTrial> none;
  const auto& level = stage_.level(Stage::A);
  return level ? level->trials : none;
}

QRectF AutoCurve::plot() const {
  const int line = fontMetrics().height();
  const int left = fontMetrics().horizontalAdvance(metresText(highest())) + line;
  return QRectF(rect()).adjusted(left, 1.8 * line, -line, -2.2 * line);
}

double AutoCurve::highest() const {
  double most = 1e-9;
  for (const AutoTrial& trial : trials()) most = std::max(most, trial.widestGap + trial.hausdorff);
  return most * 1.1;
}

QPointF AutoCurve::at(double a, double metres) const {
  const QRectF area = plot();
  return {area.left() + (a - kLeast) / (kMost - kLeast) * area.width(),
          area.bottom() - metres / highest() * area.height()};
}

QPointF AutoCurve::placeOf(const AutoTrial& trial) const {
  return at(trial.a, trial.widestGap + trial.hausdorff);
}

void AutoCurve::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (trials().empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Tick “Find a” to see what each value of a does to gaps and distances."));
    return;
  }
  const auto none = [](const AutoTrial&) { return 0.0; };
  const auto distance = [](const AutoTrial& trial) { return trial.hausdorff; };
  const auto both = [](const AutoTrial& trial) { return trial.hausdorff + trial.widestGap; };
  paintBand(painter, distanceColour(), none, distance);
  paintBand(painter, gapColour(), distance, both);
  paintAxes(painter);
  paintTrials(painter);
}

void AutoCurve::paintBand(QPainter& painter, const QColor& colour, double (*low)(const AutoTrial&),
                          double (*high)(const AutoTrial&)) const {
  QPolygonF band;
  for (const AutoTrial& trial : trials()) band << at(trial.a, high(trial));
  for (auto trial = trials().rbegin(); trial != trials().rend(); ++trial) band << at(trial->a, low(*trial));
  painter.setPen(Qt::NoPen);
  painter.setBrush(mixed(palette().color(QPalette::Base), colour, 0.75));
  painter.drawPolygon(band);
}

void AutoCurve::paintAxes(QPainter& painter) const {
  const QRectF area = plot();
  const int line = fontMetrics().height();
  painter.setPen(palette().color(QPalette::Text));
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  for (int a = 1; a <= static_cast<int>(kMost); ++a) {
    const QPointF foot = at(a, 0);
    painter.drawLine(foot, foot + QPointF(0, 4));
    painter.drawText(QRectF(foot.x() - line, foot.y() + 4, 2 * line, line), Qt::AlignCenter,
                     QString::number(a));
  }
  painter.drawText(QRectF(area.left(), area.bottom() + 1.1 * line, area.width(), line), Qt::AlignCenter,
                   tr("a"));
  for (const double share : {0.0, 0.5, 1.0}) {
    if (share > 0 && highest() < kNoise) continue;
    const double metres = share * highest() / 1.1;
    const double y = at(kLeast, metres).y();
    painter.drawText(QRectF(0, y - line, area.left() - 6, 2 * line), Qt::AlignRight | Qt::AlignVCenter,
                     metresText(metres));
  }
  // The legend, above the plot.
  double x = area.left();
  for (const auto& [colour, text] :
       {std::pair(gapColour(), tr("widest gap")), std::pair(distanceColour(), tr("Hausdorff distance"))}) {
    painter.fillRect(QRectF(x, line * 0.55, line * 0.6, line * 0.6), colour);
    painter.drawText(QPointF(x + line * 0.9, line * 1.1), text);
    x += fontMetrics().horizontalAdvance(text) + 2.2 * line;
  }
}

void AutoCurve::paintTrials(QPainter& painter) const {
  const double chosen = stage_.level(Stage::A)->a;
  for (const AutoTrial& trial : trials()) {
    const QPointF place = placeOf(trial);
    const bool best = trial.a == chosen;
    if (best) {
      painter.setPen(QPen(palette().color(QPalette::Highlight), 2, Qt::DashLine));
      painter.drawLine(QPointF(place.x(), plot().top() - 4), QPointF(place.x(), plot().bottom()));
    }
    painter.setPen(QPen(palette().color(QPalette::Text), best ? 2 : 1.2));
    painter.setBrush(best ? palette().color(QPalette::Highlight) : palette().color(QPalette::Base));
    painter.drawEllipse(place, best ? 6 : 4, best ? 6 : 4);
  }
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRectF(0, 0, width() - 8, fontMetrics().height() * 1.6), Qt::AlignRight | Qt::AlignVCenter,
                   tr("taken: a = %1").arg(QLocale().toString(chosen)));
}

const AutoTrial* AutoCurve::trialNear(double x) const {
  const AutoTrial* best = nullptr;
  for (const AutoTrial& trial : trials()) {
    const double away = std::abs(placeOf(trial).x() - x);
    if (away < kReach && (!best || away < std::abs(placeOf(*best).x() - x))) best = &trial;
  }
  return best;
}

void AutoCurve::mousePressEvent(QMouseEvent* event) {
  const AutoTrial* trial = trialNear(event->position().x());
  if (!trial || event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  SimplifyOptions options = stage_.options(Stage::A);
  options.a = trial->a;
  options.aAuto = false;
  stage_.setOptions(Stage::A, options, tr("Take a = %1").arg(QLocale().toString(trial->a)));
}

bool AutoCurve::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const AutoTrial* trial = trialNear(help->pos().x());
  QToolTip::showText(
      help->globalPos(),
      !trial
          ? QString()
          : tr("a = %1: widest gap %2, Hausdorff distance %3, %4 contacts separated, %5 lost. "
               "Click to take it.")
                .arg(QLocale().toString(trial->a), metresText(trial->widestGap), metresText(trial->hausdorff))
                .arg(trial->separated)
                .arg(trial->lost),
      this);
  return true;
}

}  // namespace lodestone
