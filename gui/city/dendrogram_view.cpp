#include "gui/city/dendrogram_view.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/widgets/colours.h"
#include "gui/widgets/icons.h"
#include "gui/workspace/workspace.h"

namespace lodestone {
namespace {

constexpr double kFewestLeaves = 4;   // closest zoom
constexpr int kGrip = 5;              // pixels around the cut line that take hold of it
constexpr double kWheelFactor = 0.8;  // a notch
constexpr double kHeadroom = 1.06;    // of the highest bar

}  // namespace

QString shortNumber(double value) {
  const char* const endings[] = {"", "k", "M", "G", "T", "P"};
  std::size_t power = 0;
  while (std::abs(value) >= 1000 && power + 1 < std::size(endings)) {
    value /= 1000;
    ++power;
  }
  const int decimals = std::abs(value) < 10 && value != std::floor(value) ? 1 : 0;
  return QLocale().toString(value, 'f', decimals) + QLatin1String(endings[power]);
}

DendrogramView::DendrogramView(Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace) {
  setObjectName(QStringLiteral("dendrogram"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Dendrogram"));
  setWhatsThis(
      tr("<p>How buildings join to clusters: each bar is a merge, at the height of its weight w = size · "
         "size · distance "
         "(Chang et al. 2008, Eq. 1), on a logarithmic axis.</p><p>Drag the line to cut the tree at a "
         "weight. Wheel: zoom; "
         "Ctrl and wheel: zoom the weights; drag: pan; click: select; double-click: zoom to a cluster; Home: "
         "show all.</p>"));
  connect(&workspace_, &Workspace::stateChanged, this,
          [this](const ProjectState& before, const ProjectState& after) {
            if (before.tree != after.tree) treeChanged();
          });
  connect(&workspace_, &Workspace::cutChanged, this, &DendrogramView::cutChanged);
  connect(&workspace_, &Workspace::selectionChanged, this, qOverload<>(&QWidget::update));
  connect(&workspace_, &Workspace::hoverChanged, this, qOverload<>(&QWidget::update));
}

void DendrogramView::treeChanged() {
  const auto& tree = workspace_.state().tree;
  layout_ = tree ? makeLayout(tree->dendrogram) : DendrogramLayout();
  lineHeight_ = layout_.top * 0.6;
  showAll();
}

void DendrogramView::cutChanged() {
  const auto& tree = workspace_.state().tree;
  const auto& cut = workspace_.cut();
  drawn_.assign(tree && cut ? tree->nodes.size() : 0, 0);
  clusters_ = 0;
  if (!drawn_.empty()) {
    for (const DrawnNode& node : cut->drawn) {
      if (node.role == DrawRole::Landmark) continue;
      drawn_[node.node] = 1;
      ++clusters_;
    }
    for (const NodeId node : cut->culled) drawn_[node] = 1;
  }
  const CutChoice& choice = workspace_.state().cutChoice;
  if (choice.mode == CutMode::Weight) lineHeight_ = heightOfWeight(choice.value);
  update();
}

void DendrogramView::showAll() {
  left_ = 0;
  right_ = std::max<double>(layout_.order.leaves.size(), 1);
  bottom_ = kLeafHeight;
  top_ = layout_.top * kHeadroom;
  update();
}

void DendrogramView::zoomTo(NodeId node) {
  if (node == kNoNode || node >= layout_.x.size()) return;
  const double first = layout_.order.first[node];
  const double count = layout_.order.count[node];
  left_ = first - count * 0.05;
  right_ = first + count * 1.05;
  bottom_ = kLeafHeight;
  top_ = std::max<double>(layout_.height[node] * kHeadroom + 0.2, 1);
  clampWindow();
}

void DendrogramView::clampWindow() {
  const double all = std::max<double>(layout_.order.leaves.size(), 1);
  const double span = std::clamp(right_ - left_, std::min(kFewestLeaves, all), all);
  left_ = std::clamp(left_, 0.0, all - span);
  right_ = left_ + span;
  const double highest = layout_.top * kHeadroom;
  const double heights =
      std::clamp(top_ - bottom_, std::min(0.5, highest - kLeafHeight), highest - kLeafHeight);
  bottom_ = std::clamp(bottom_, kLeafHeight, highest - heights);
  top_ = bottom_ + heights;
  update();
}

void DendrogramView::zoom(double factor, double centre) {
  left_ = centre - (centre - left_) * factor;
  right_ = centre + (right_ - centre) * factor;
  clampWindow();
}

void DendrogramView::zoomHeights(double factor, double centre) {
  bottom_ = centre - (centre - bottom_) * factor;
  top_ = centre + (top_ - centre) * factor;
  clampWindow();
}

void DendrogramView::pan(double leaves, double heights) {
  left_ += leaves;
  right_ += leaves;
  bottom_ += heights;
  top_ += heights;
  clampWindow();
}

void DendrogramView::moveLine(double height) {
  if (!layout_.dendrogram) return;
  lineHeight_ = std::clamp(height, 0.0, layout_.top * 1.02);
  workspace_.setCutChoice({CutMode::Weight, weightOfHeight(lineHeight_)});
}

QRect DendrogramView::plotRect() const {
  const QFontMetrics metrics(font());
  const int left = metrics.horizontalAdvance(QStringLiteral("100M")) + metrics.height() * 7 / 4;
  return rect().adjusted(left, metrics.height() / 2, -metrics.height() / 2, -metrics.height() - 6);
}

DendrogramWindow DendrogramView::window() const {
  const QRect plot = plotRect();
  return {left_, right_, bottom_, top_, plot.width(), plot.height()};
}

NodeId DendrogramView::nodeAt(const QPointF& position) const {
  const QRect plot = plotRect();
  if (!plot.contains(position.toPoint())) return kNoNode;
  const DendrogramWindow view = window();
  return layout_.nodeAt(view.xAt(position.x() - plot.left()), view.heightAt(position.y() - plot.top()));
}

bool DendrogramView::onLine(const QPointF& position) const {
  return layout_.dendrogram && std::abs(position.y() - linePosition().y()) <= kGrip &&
         position.x() >= plotRect().left();
}

QPoint DendrogramView::linePosition() const {
  const QRect plot = plotRect();
  return {plot.center().x(), plot.top() + static_cast<int>(std::lround(window().row(lineHeight_)))};
}

QPoint DendrogramView::positionOf(NodeId node) const {
  const QRect plot = plotRect();
  const DendrogramWindow view = window();
  return {plot.left() + static_cast<int>(view.column(layout_.x[node])),
          plot.top() + static_cast<int>(view.row(layout_.height[node]))};
}

QSize DendrogramView::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 110, fontMetrics().height() * 13};
}
QSize DendrogramView::minimumSizeHint() const {
  return {fontMetrics().averageCharWidth() * 30, fontMetrics().height() * 7};
}

void DendrogramView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton) return;
  dragFrom_ = event->position();
  drag_ = onLine(event->position()) ? Drag::Line : Drag::Press;
}

void DendrogramView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF moved = event->position() - dragFrom_;
  if (drag_ == Drag::Press && moved.manhattanLength() > 4) drag_ = Drag::Pan;
  if (drag_ == Drag::Line) {
    moveLine(window().heightAt(event->position().y() - plotRect().top()));
  } else if (drag_ == Drag::Pan) {
    const DendrogramWindow view = window();
    pan(-moved.x() / std::max(view.width, 1) * (right_ - left_),
        moved.y() / std::max(view.height, 1) * (top_ - bottom_));
    dragFrom_ = event->position();
  } else {
    setCursor(onLine(event->position()) ? Qt::SizeVerCursor : Qt::ArrowCursor);
    workspace_.setHover(nodeAt(event->position()));
  }
}

void DendrogramView::mouseReleaseEvent(QMouseEvent* event) {
  if (drag_ == Drag::Press) {
    const NodeId node = nodeAt(event->position());
    workspace_.select(node == kNoNode ? std::vector<NodeId>() : std::vector<NodeId>{node});
  }
  drag_ = Drag::None;
}

void DendrogramView::mouseDoubleClickEvent(QMouseEvent* event) {
  const NodeId node = nodeAt(event->position());
  if (node == kNoNode) return;
  zoomTo(node);
  workspace_.flyTo(node);
}

void DendrogramView::leaveEvent(QEvent*) {
  workspace_.setHover(kNoNode);
}

void DendrogramView::wheelEvent(QWheelEvent* event) {
  const QRect plot = plotRect();
  const DendrogramWindow view = window();
  const double factor = std::pow(kWheelFactor, event->angleDelta().y() / 120.0);
  if (event->modifiers() & Qt::ControlModifier) {
    zoomHeights(factor, view.heightAt(event->position().y() - plot.top()));
  } else {
    zoom(factor, view.xAt(event->position().x() - plot.left()));
  }
  event->accept();
}

void DendrogramView::keyPressEvent(QKeyEvent* event) {
  const double step = (right_ - left_) / 10;
  switch (event->key()) {
    case Qt::Key_Left:
      return pan(-step, 0);
    case Qt::Key_Right:
      return pan(step, 0);
    case Qt::Key_Up:
      return moveLine(lineHeight_ + layout_.top / 50);
    case Qt::Key_Down:
      return moveLine(lineHeight_ - layout_.top / 50);
    case Qt::Key_Plus:
      return zoom(kWheelFactor, (left_ + right_) / 2);
    case Qt::Key_Minus:
      return zoom(1 / kWheelFactor, (left_ + right_) / 2);
    case Qt::Key_Home:
      return showAll();
    default:
      QWidget::keyPressEvent(event);
  }
}

bool DendrogramView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && layout_.dendrogram) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const NodeId node = nodeAt(help->pos());
    QString text = node == kNoNode ? QString() : workspace_.nameOf(node);
    if (node != kNoNode && !layout_.dendrogram->isLeaf(node)) {
      const Merge& merge = layout_.dendrogram->merge(node);
      text += tr("\nweight %1, distance %2 m")
                  .arg(shortNumber(merge.weight), QLocale().toString(merge.distance, 'f', 1));
    }
    QToolTip::showText(help->globalPos(), text, this);
    return true;
  }
  return QWidget::event(event);
}

void DendrogramView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (!layout_.dendrogram || layout_.dendrogram->merges.empty()) {
    paintEmpty(painter);
    return;
  }
  paintAxes(painter);
  painter.save();
  painter.setClipRect(plotRect());
  for (const NodeId node : workspace_.selection()) paintNode(painter, node, selectionColour());
  paintNode(painter, workspace_.hover(), accentColor());
  painter.restore();
  paintTree(painter);
  paintLine(painter);
}

void DendrogramView::paintEmpty(QPainter& painter) const {
  painter.setPen(palette().color(QPalette::PlaceholderText));
  const bool alone = workspace_.canCluster() && workspace_.state().city->buildings.size() == 1;
  const QString text = alone ? tr("One building alone: there is nothing to group.")
                       : workspace_.canCluster()
                           ? tr("Press “Cluster” to group the buildings: the tree appears here.")
                           : tr("Open a city model to see how its buildings join to clusters.");
  painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, text);
}

void DendrogramView::paintTree(QPainter& painter) {
  const QRect plot = plotRect();
  const double ratio = devicePixelRatioF();
  DendrogramWindow view = window();
  view.width = static_cast<int>(view.width * ratio);
  view.height = static_cast<int>(view.height * ratio);
  if (view.width <= 0 || view.height <= 0) return;
  raster_.draw(layout_, view, drawn_);
  if (picture_.size() != QSize(view.width, view.height)) {
    picture_ = QImage(view.width, view.height, QImage::Format_ARGB32_Premultiplied);
  }
  picture_.setDevicePixelRatio(ratio);
  const QColor ink = mixed(palette().color(QPalette::Text), palette().color(QPalette::Base), 0.25);
  std::vector<QRgb> below(static_cast<std::size_t>(view.width));
  for (int x = 0; x < view.width; ++x)
    below[static_cast<std::size_t>(x)] = clusterColour(raster_.owner(x), palette()).rgb();
  for (int y = 0; y < view.height; ++y) {
    auto* line = reinterpret_cast<QRgb*>(picture_.scanLine(y));
    for (int x = 0; x < view.width; ++x) {
      const std::uint32_t above = raster_.above(x, y);
      line[x] = above != 0 ? ink.rgb() : raster_.below(x, y) != 0 ? below[static_cast<std::size_t>(x)] : 0;
    }
  }
  painter.drawImage(plot.topLeft(), picture_);
}

void DendrogramView::paintAxes(QPainter& painter) const {
  const QRect plot = plotRect();
  const DendrogramWindow view = window();
  const QFontMetrics metrics(font());
  const QColor text = mixed(palette().color(QPalette::Text), palette().color(QPalette::Base), 0.3);
  const QColor grid = mixed(palette().color(QPalette::Text), palette().color(QPalette::Base), 0.88);
  double last = 1e9;
  for (double decade = -1; decade <= std::ceil(top_); ++decade) {
    const double weight = decade < 0 ? 0 : std::pow(10, decade);
    const double y = plot.top() + view.row(heightOfWeight(weight));
    if (y < plot.top() - 1 || y > plot.bottom() + 1 || last - y < metrics.height() * 1.1) continue;
    last = y;
    painter.setPen(grid);
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    painter.setPen(text);
    painter.drawText(QRectF(metrics.height(), y - metrics.height() / 2.0,
                            plot.left() - metrics.height() - 6.0, metrics.height()),
                     Qt::AlignRight | Qt::AlignVCenter, shortNumber(weight));
  }
  painter.setPen(text);
  painter.save();
  painter.translate(metrics.height() * 0.15, plot.center().y());
  painter.rotate(-90);
  painter.drawText(QRectF(-plot.height() / 2.0, 0, plot.height(), metrics.height()), Qt::AlignCenter,
                   tr("weight w"));
  painter.restore();
  const QRect below(plot.left(), plot.bottom() + 3, plot.width(), metrics.height());
  painter.drawText(below, Qt::AlignLeft,
                   QLocale().toString(static_cast<qlonglong>(std::max(left_, 0.0)) + 1));
  painter.drawText(below, Qt::AlignRight, QLocale().toString(static_cast<qlonglong>(right_)));
  painter.drawText(below, Qt::AlignHCenter, tr("buildings, in the order of the tree"));
}

void DendrogramView::paintNode(QPainter& painter, NodeId node, const QColor& colour) const {
  if (node == kNoNode || node >= layout_.x.size()) return;
  const QRect plot = plotRect();
  const DendrogramWindow view = window();
  const double first = layout_.order.first[node];
  const double last = first + layout_.order.count[node];
  QRectF area(QPointF(plot.left() + view.column(first),
                      plot.top() + view.row(std::max(layout_.height[node], 0.0F)) - 2),
              QPointF(plot.left() + view.column(last), plot.bottom()));
  if (area.width() < 3) area.adjust(-1.5, 0, 1.5, 0);
  QColor fill = colour;
  fill.setAlphaF(0.22F);
  painter.fillRect(area, fill);
  painter.setPen(QPen(colour, 1.5));
  painter.drawLine(area.topLeft(), area.topRight());
}

void DendrogramView::paintLine(QPainter& painter) const {
  const QRect plot = plotRect();
  const double y = plot.top() + window().row(lineHeight_);
  if (y < plot.top() - 1 || y > plot.bottom()) return;
  const bool active = workspace_.state().cutChoice.mode == CutMode::Weight;
  const QColor colour =
      active ? cutLineColour() : mixed(cutLineColour(), palette().color(QPalette::Base), 0.35);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, active ? 2 : 1.5, active ? Qt::SolidLine : Qt::DashLine));
  painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
  const QString text = active ? (clusters_ == 1 ? tr("w = %1 · %L2 cluster") : tr("w = %1 · %L2 clusters"))
                                    .arg(shortNumber(lineWeight()))
                                    .arg(clusters_)
                              : tr("drag to cut at a weight");
  const QFontMetrics metrics(font());
  const QSizeF size(metrics.horizontalAdvance(text) + metrics.height(), metrics.height() + 4);
  const double top = std::clamp(y - size.height() - 3, plot.top() + 0.0, plot.bottom() - size.height());
  const QRectF label(QPointF(plot.right() - size.width() - 4, top), size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawRoundedRect(label, 4, 4);
  painter.setPen(Qt::white);
  painter.drawText(label, Qt::AlignCenter, text);
}

}  // namespace lodestone
