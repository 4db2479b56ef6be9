#include "gui/perception/difference_plot.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "gui/widgets/colours.h"
#include "gui/widgets/detail_looks.h"

namespace lodestone {
namespace {

constexpr double kReach = 7;    // units from a line that still mean it
constexpr int kRoomBins = 12;   // right of the last bin that counts anything
constexpr int kLeastBins = 48;  // that are shown: 9 grey levels
constexpr int kSteps = 400;     // of a drawn Gaussian
constexpr double kMarks[] = {0, 0.1, 0.5, 1, 2, 5, 10, 20, 50, 100, 200};  // grey levels

double binOf(double greyLevels) {
  return std::sqrt(greyLevels) * std::sqrt(kDifferenceBins);
}

constexpr double kGap = 12;  // units between what is said of two classes

double swatch(const QFontMetrics& metrics) {
  return metrics.height() * 0.6;
}

/// "88 %", "1.4 %": what there is of at all is never 0.
QString percentText(double share) {
  const QLocale locale;
  if (share > 0 && share < 0.0005) return DifferencePlot::tr("< %1 %").arg(locale.toString(0.1));
  return DifferencePlot::tr("%1 %").arg(locale.toString(share * 100, 'f', share > 0 && share < 0.0195 ? 1 : 0));
}

DetailClass above(std::size_t cut) {
  return static_cast<DetailClass>(cut + 1);
}

}  // namespace

DifferencePlot::DifferencePlot(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Histogram of differences: pixels by grey levels"));
  setWhatsThis(tr(
      "How many pixels differ how much between the rendered picture and what the eye lets through of it, "
      "over all views (Du, Zhu and Zhao, section 3.2). Curves are the four Gaussians of maximum likelihood, "
      "weighted by their priors. Drag a line to cut two classes elsewhere: triangles are judged again at "
      "once. Double-click it to have it found again. Keys: 1 to 3 choose a line, the arrows move it, "
      "Delete has it found."));
}

QSize DifferencePlot::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 60, fontMetrics().height() * 12};
}

QSize DifferencePlot::minimumSizeHint() const {
  return {fontMetrics().averageCharWidth() * 28, fontMetrics().height() * 7};
}

void DifferencePlot::show(const DifferenceHistogram& histogram, const DifferenceClasses& classes,
                          const std::array<bool, kCuts>& fixed) {
  histogram_ = histogram;
  const auto dragged = classes_.cuts;
  classes_ = classes;
  if (grabbed_) classes_.cuts[*grabbed_] = dragged[*grabbed_];
  fixed_ = fixed;
  total_ = std::accumulate(histogram_.begin(), histogram_.end(), std::uint64_t{0});
  most_ = std::max<std::uint64_t>(1, *std::max_element(histogram_.begin(), histogram_.end()));
  shown_ = true;
  update();
}

void DifferencePlot::clear(const QString& message) {
  shown_ = false;
  message_ = message;
  grabbed_.reset();
  update();
}

QRectF DifferencePlot::plot() const {
  const int line = fontMetrics().height();
  const int left = fontMetrics().horizontalAdvance(QStringLiteral("10⁶")) + line / 2;
  return QRectF(rect()).adjusted(left, 1.7 * line, -line / 2, -2.3 * line);
}

/// The last bin that is shown, and then some.
int DifferencePlot::lastBin() const {
  int last = kLeastBins;
  for (int bin = 0; bin < kDifferenceBins; ++bin) {
    if (histogram_[static_cast<std::size_t>(bin)] > 0) last = std::max(last, bin + kRoomBins);
  }
  for (const int cut : classes_.cuts) {
    if (cut < kDifferenceBins) last = std::max(last, cut + kRoomBins / 2);
  }
  return std::min(last, kDifferenceBins);
}

double DifferencePlot::placeOfBin(double bin) const {
  const QRectF area = plot();
  return area.left() + std::min(bin / lastBin(), 1.0) * area.width();
}

double DifferencePlot::placeOfCut(std::size_t cut) const {
  return placeOfBin(classes_.cuts[cut]);
}

double DifferencePlot::placeOfCount(double count) const {
  const QRectF area = plot();
  const double share = std::log10(std::max(count, 0.5) * 2) / std::log10(static_cast<double>(most_) * 4);
  return area.bottom() - share * area.height();
}

void DifferencePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!shown_) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, message_);
    return;
  }
  paintShares(painter);
  paintBands(painter);
  paintHistogram(painter);
  paintGaussians(painter);
  paintAxes(painter);
  paintCuts(painter);
}

/// From the first to behind the last, by the cuts as drawn.
std::pair<int, int> DifferencePlot::binsOf(DetailClass detail) const {
  const auto i = static_cast<std::size_t>(detail);
  return {i == 0 ? 0 : classes_.cuts[i - 1], i == kCuts ? kDifferenceBins : classes_.cuts[i]};
}

/// Of the pixels.
double DifferencePlot::shareOf(DetailClass detail) const {
  const auto [begin, end] = binsOf(detail);
  const auto pixels = std::accumulate(histogram_.begin() + begin, histogram_.begin() + end, std::uint64_t{0});
  return total_ > 0 ? static_cast<double>(pixels) / static_cast<double>(total_) : 0;
}

double DifferencePlot::roomOf(const QStringList& texts) const {
  double room = 0;
  for (const QString& text : texts)
    room += fontMetrics().horizontalAdvance(text) + swatch(fontMetrics()) + kGap;
  return room;
}

/// "None 88 %", …
QStringList DifferencePlot::namedShares() const {
  QStringList texts;
  for (const DetailClass detail : kAllDetail)
    texts << nameOf(detail) + QLatin1Char(' ') + percentText(shareOf(detail));
  return texts;
}

/// Not over the bands themselves: most of them are too narrow for words.
QStringList DifferencePlot::shares() const {
  const QStringList named = namedShares();
  if (roomOf(named) <= width()) return named;
  QStringList bare;
  for (const DetailClass detail : kAllDetail) bare << percentText(shareOf(detail));
  return bare;
}

void DifferencePlot::paintShares(QPainter& painter) const {
  const QStringList texts = shares();
  const double side = swatch(fontMetrics());
  const double height = fontMetrics().height();
  const double spread = std::max(0.0, (width() - roomOf(texts)) / static_cast<double>(texts.size()));
  double x = kGap / 2 + spread / 2;
  for (const DetailClass detail : kAllDetail) {
    const QString& text = texts[static_cast<qsizetype>(detail)];
    painter.fillRect(QRectF(x, 2 + (height - side) / 2, side, side), colourOf(detail));
    painter.setPen(palette().color(QPalette::Text));
    const double wide = fontMetrics().horizontalAdvance(text);
    painter.drawText(QRectF(x + side + kGap / 2, 2, wide + 1, height), Qt::AlignLeft | Qt::AlignVCenter,
                     text);
    x += side + wide + kGap + spread;
  }
}

/// The range of each class.
void DifferencePlot::paintBands(QPainter& painter) const {
  const QRectF area = plot();
  for (const DetailClass detail : kAllDetail) {
    const auto [begin, end] = binsOf(detail);
    const QRectF band(QPointF(placeOfBin(begin), area.top()), QPointF(placeOfBin(end), area.bottom()));
    painter.fillRect(band, mixed(palette().color(QPalette::Base), colourOf(detail), 0.16));
    painter.fillRect(QRectF(band.left(), band.top() - 3, band.width(), 3), colourOf(detail));
  }
}

void DifferencePlot::paintHistogram(QPainter& painter) const {
  painter.setPen(Qt::NoPen);
  painter.setBrush(mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.35));
  const double bottom = plot().bottom();
  for (int bin = 0; bin < lastBin(); ++bin) {
    const std::uint64_t count = histogram_[static_cast<std::size_t>(bin)];
    if (count == 0) continue;
    const double top = placeOfCount(static_cast<double>(count));
    painter.drawRect(QRectF(QPointF(placeOfBin(bin), top), QPointF(placeOfBin(bin + 1), bottom)));
  }
}

/// Pixels a bin that each Gaussian stands for.
void DifferencePlot::paintGaussians(QPainter& painter) const {
  painter.save();
  painter.setClipRect(plot());
  painter.setBrush(Qt::NoBrush);
  for (const DetailClass detail : kAllDetail) {
    const Gaussian& gaussian = classes_.gaussians[static_cast<std::size_t>(detail)];
    if (gaussian.prior <= 0 || gaussian.sigma <= 0) continue;
    QPainterPath path;
    for (int i = 0; i <= kSteps; ++i) {
      const double bin = static_cast<double>(i) / kSteps * lastBin();
      const double grey = bin * bin / kDifferenceBins;
      const double wide = (2 * bin + 1) / kDifferenceBins;  // of a bin from here, grey levels
      const double off = (grey - gaussian.mean) / gaussian.sigma;
      const double density = std::exp(-off * off / 2) / (gaussian.sigma * std::sqrt(2 * std::numbers::pi));
      const QPointF at(placeOfBin(bin),
                       placeOfCount(static_cast<double>(total_) * gaussian.prior * density * wide));
      i == 0 ? path.moveTo(at) : path.lineTo(at);
    }
    painter.setPen(QPen(palette().color(QPalette::Base), 4));
    painter.drawPath(path);
    painter.setPen(QPen(colourOf(detail), 2));
    painter.drawPath(path);
  }
  painter.restore();
}

void DifferencePlot::paintAxes(QPainter& painter) const {
  const QRectF area = plot();
  const int line = fontMetrics().height();
  painter.setPen(palette().color(QPalette::Text));
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  double free = area.left() - line;
  for (const double grey : kMarks) {
    const double bin = binOf(grey);
    if (bin > lastBin()) break;
    const double x = placeOfBin(bin);
    const QString text = QLocale().toString(grey);
    const double half = fontMetrics().horizontalAdvance(text) / 2.0;
    painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + 4));
    if (x - half < free) continue;
    painter.drawText(QRectF(x - line * 2, area.bottom() + 4, line * 4, line), Qt::AlignCenter, text);
    free = x + half + 4;
  }
  painter.drawText(QRectF(0, area.bottom() + 1.15 * line, width(), line), Qt::AlignCenter,
                   tr("pixels by difference, grey levels (0–255)"));
  static const char* const kPowers[] = {"1", "10", "10²", "10³", "10⁴", "10⁵", "10⁶", "10⁷", "10⁸", "10⁹"};
  double above = area.bottom() + line;
  for (std::size_t power = 0; power < std::size(kPowers); ++power) {
    const double y = placeOfCount(std::pow(10, static_cast<double>(power)));
    if (y < area.top()) break;
    painter.drawLine(QPointF(area.left() - 3, y), QPointF(area.left(), y));
    if (above - y < line) continue;
    painter.drawText(QRectF(0, y - line, area.left() - 5, 2 * line), Qt::AlignRight | Qt::AlignVCenter,
                     QString::fromUtf8(kPowers[power]));
    above = y;
  }
}

void DifferencePlot::paintCuts(QPainter& painter) const {
  const QRectF area = plot();
  for (std::size_t cut = 0; cut < kCuts; ++cut) {
    const double x = placeOfCut(cut);
    const bool chosen = hasFocus() && cut == chosen_;
    const QColor ink = palette().color(QPalette::Text);
    painter.setPen(QPen(ink, chosen ? 2.5 : 1.5, fixed_[cut] ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    QPolygonF grip;
    const double y = area.bottom() - area.height() * (0.10 + 0.14 * static_cast<double>(cut));
    grip << QPointF(x - 5, y) << QPointF(x, y - 7) << QPointF(x + 5, y) << QPointF(x, y + 7);
    painter.setPen(QPen(chosen ? palette().color(QPalette::Highlight) : ink, chosen ? 2.5 : 1.2));
    painter.setBrush(colourOf(above(cut)));
    painter.drawPolygon(grip);
  }
}

std::optional<std::size_t> DifferencePlot::cutNear(double x) const {
  if (!shown_) return {};
  std::optional<std::size_t> best;
  for (std::size_t cut = 0; cut < kCuts; ++cut) {
    const double away = std::abs(placeOfCut(cut) - x);
    // Of lines in one place the one that can go where the pointer is.
    if (away > kReach || (best && away > std::abs(placeOfCut(*best) - x))) continue;
    if (best && away == std::abs(placeOfCut(*best) - x) && x < placeOfCut(cut)) continue;
    best = cut;
  }
  return best;
}

void DifferencePlot::moveCut(std::size_t cut, int bin) {
  const int low = cut == 0 ? 1 : classes_.cuts[cut - 1];
  const int high = std::min(cut + 1 == kCuts ? kDifferenceBins : classes_.cuts[cut + 1], kDifferenceBins - 1);
  bin = std::clamp(bin, std::min(low, high), high);
  if (bin == classes_.cuts[cut]) return;
  classes_.cuts[cut] = bin;
  fixed_[cut] = true;
  update();
  Q_EMIT cutMoved(cut, bin);
}

void DifferencePlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  grabbed_ = cutNear(event->position().x());
  if (grabbed_) chosen_ = *grabbed_;
  update();
}

void DifferencePlot::mouseMoveEvent(QMouseEvent* event) {
  if (grabbed_) {
    const QRectF area = plot();
    const double share = (event->position().x() - area.left()) / area.width();
    return moveCut(*grabbed_, static_cast<int>(std::lround(share * lastBin())));
  }
  cutNear(event->position().x()) ? setCursor(Qt::SplitHCursor) : unsetCursor();
}

void DifferencePlot::mouseReleaseEvent(QMouseEvent*) {
  grabbed_.reset();
}

void DifferencePlot::mouseDoubleClickEvent(QMouseEvent* event) {
  const auto cut = cutNear(event->position().x());
  grabbed_.reset();
  if (cut) Q_EMIT cutReset(*cut);
}

void DifferencePlot::keyPressEvent(QKeyEvent* event) {
  if (!shown_) return QWidget::keyPressEvent(event);
  const int key = event->key();
  if (key >= Qt::Key_1 && key < Qt::Key_1 + static_cast<int>(kCuts)) {
    chosen_ = static_cast<std::size_t>(key - Qt::Key_1);
    update();
  } else if (key == Qt::Key_Left || key == Qt::Key_Right) {
    moveCut(chosen_, std::min(classes_.cuts[chosen_], lastBin()) + (key == Qt::Key_Left ? -1 : 1));
  } else if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
    Q_EMIT cutReset(chosen_);
  } else {
    QWidget::keyPressEvent(event);
  }
}

QString DifferencePlot::helpAt(const QPointF& at) const {
  const QLocale locale;
  if (shown_ && at.y() < plot().top()) return tr("Of the pixels: %1").arg(namedShares().join(tr(", ")));
  if (const auto cut = cutNear(at.x())) {
    const int bin = classes_.cuts[*cut];
    const QString where =
        bin < kDifferenceBins
            ? tr("%1 from %2 grey levels").arg(nameOf(above(*cut)), locale.toString(binBegin(bin), 'g', 3))
            : tr("%1: no pixels").arg(nameOf(above(*cut)));
    return where + (fixed_[*cut] ? tr(", set by hand. Double-click: found again.")
                                 : tr(", found by maximum likelihood. Drag to set it."));
  }
  if (!shown_ || !plot().contains(at)) return {};
  const int bin = std::clamp(static_cast<int>((at.x() - plot().left()) / plot().width() * lastBin()), 0,
                             kDifferenceBins - 1);
  return tr("%1 to %2 grey levels: %3 pixels")
      .arg(locale.toString(binBegin(bin), 'g', 3), locale.toString(binBegin(bin + 1), 'g', 3),
           locale.toString(static_cast<qulonglong>(histogram_[static_cast<std::size_t>(bin)])));
}

bool DifferencePlot::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), helpAt(help->pos()), this);
  return true;
}

}  // namespace lodestone
