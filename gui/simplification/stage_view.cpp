#include "gui/simplification/stage_view.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

#include <vtkRenderer.h>

namespace lodestone {
namespace {

constexpr int kLineWidth = 18;      // that can be grabbed
constexpr double kVertexReach = 9;  // pixels from a vertex that still mean it
constexpr double kKeyStep = 0.02;

}  // namespace

/// The scene goes into the base, which is made first.
struct StageScene::BuildingContent {
  std::vector<vtkSmartPointer<vtkRenderer>> renderers;
  std::unique_ptr<BuildingScene> scene;
  BuildingScene* kept = nullptr;

  BuildingContent() {
    for (std::size_t i = 0; i < BuildingScene::kPanes; ++i)
      renderers.push_back(vtkSmartPointer<vtkRenderer>::New());
    scene = std::make_unique<BuildingScene>(renderers);
    kept = scene.get();
  }
};

StageScene::StageScene(QWidget* parent) : StageScene(BuildingContent(), parent) {}

StageScene::StageScene(BuildingContent content, QWidget* parent)
    : SceneWidget({std::move(content.renderers), std::move(content.scene)}, parent), scene_(content.kept) {}

void StageScene::clicked(const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
  if (button == Qt::LeftButton && tool_ && tool_->click(at)) return;
  if (const auto target = scene_->pickTarget(at.x(), at.y())) return targetPicked(*target);
  const bool add = (modifiers & (Qt::ControlModifier | Qt::ShiftModifier)) != 0;
  const auto part = scene_->pick(at.x(), at.y(), kVertexReach * devicePixelRatioF());
  if (button == Qt::LeftButton || part) Q_EMIT picked(part, add);
}

void StageScene::rested(const QPointF& at) {
  const auto part = scene_->pickTarget(at.x(), at.y()) ? std::nullopt : scene_->pick(at.x(), at.y());
  Q_EMIT hovered(part ? part->component : kNoNode);
}

void StageScene::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && tool_ && tool_->cancel()) return;
  SceneWidget::keyPressEvent(event);
}

void StageScene::left() {
  Q_EMIT hovered(kNoNode);
}

StageView::StageView(QWidget* parent)
    : QWidget(parent), view_(new StageScene(this)), header_(new QWidget(this)), line_(new WipeLine(view_)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  header_->setFixedHeight(fontMetrics().height() * 2);
  layout->addWidget(header_);
  layout->addWidget(view_, 1);
  for (QLabel*& title : titles_) {
    title = new QLabel(header_);
    title->setTextFormat(Qt::RichText);
    title->setAlignment(Qt::AlignCenter);
  }
  for (std::size_t i = 1; i < BuildingScene::kPanes; ++i) {
    auto* parting = new QWidget(view_);
    parting->setAutoFillBackground(true);
    parting->setAttribute(Qt::WA_TransparentForMouseEvents);
    partings_.push_back(parting);
  }
  line_->hide();
  view_->installEventFilter(this);
  connect(line_, &WipeLine::moved, this, &StageView::setWipe);
}

void StageView::setLayout(PaneLayout layout, const std::vector<std::size_t>& panes) {
  scene().setLayout(layout, panes);
  place();
}

void StageView::setTitle(std::size_t pane, const QString& title, const QString& detail) {
  titles_[pane]->setText(
      QStringLiteral("<b>%1</b>&nbsp; %2").arg(title.toHtmlEscaped(), detail.toHtmlEscaped()));
}

void StageView::setWipe(double share) {
  scene().setWipe(share);
  place();
}

void StageView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place();
}

bool StageView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize) place();
  return QWidget::eventFilter(watched, event);
}

/// Titles stand over the middle of their panes, lines between them.
void StageView::place() {
  const double ratio = devicePixelRatioF();
  const std::vector<std::size_t>& panes = scene().panes();
  const bool wipes = scene().layout() == PaneLayout::Wipe;
  scene().setSize(qRound(view_->width() * ratio), qRound(view_->height() * ratio), ratio);
  for (QLabel* title : titles_) title->hide();
  for (QWidget* parting : partings_) parting->hide();
  const int count = static_cast<int>(panes.size());
  for (int i = 0; i < count; ++i) {
    QLabel* title = titles_[panes[static_cast<std::size_t>(i)]];
    title->setGeometry(width() * i / count, 0, width() / count, header_->height());
    title->show();
    if (i == 0 || wipes) continue;
    QWidget* parting = partings_[static_cast<std::size_t>(i - 1)];
    const double left = scene().spanOf(panes[static_cast<std::size_t>(i)]).first / ratio;
    parting->setGeometry(qRound(left) - 1, 0, 2, view_->height());
    parting->show();
    parting->raise();
  }
  line_->setVisible(wipes);
  line_->setGeometry(qRound(scene().wipe() * view_->width()) - kLineWidth / 2, 0, kLineWidth,
                     view_->height());
  line_->raise();
}

QImage StageView::picture() {
  QImage image = grab().toImage();
  QPainter painter(&image);  // an OpenGL surface does not always come along
  painter.drawImage(QRect(view_->pos(), view_->size()), view_->grabImage());
  for (QWidget* over : partings_) {
    if (over->isVisible()) over->render(&painter, view_->pos() + over->pos());
  }
  if (line_->isVisible()) line_->render(&painter, view_->pos() + line_->pos(), {}, QWidget::DrawChildren);
  return image;
}

WipeLine::WipeLine(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("wipeLine"));
  setCursor(Qt::SplitHCursor);
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(tr("Wipe"));
  setToolTip(tr("Drag to wipe between the two models; the arrow keys move it too"));
}

void WipeLine::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double middle = width() / 2.0;
  painter.fillRect(QRectF(middle - 1, 0, 2, height()), palette().color(QPalette::Highlight));
  const QRectF grip(middle - 7, height() / 2.0 - 16, 14, 32);
  painter.setPen(QPen(palette().color(QPalette::Highlight), hasFocus() ? 3 : 1.5));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRoundedRect(grip, 6, 6);
  painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
  for (const double x : {-2.5, 2.5})
    painter.drawLine(QPointF(middle + x, grip.center().y() - 6), QPointF(middle + x, grip.center().y() + 6));
}

double WipeLine::share() const {
  return (x() + width() / 2.0) / std::max(parentWidget()->width(), 1);
}

void WipeLine::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    Q_EMIT moved(mapToParent(event->position()).x() / std::max(parentWidget()->width(), 1));
}

void WipeLine::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) {
    Q_EMIT moved(share() + (event->key() == Qt::Key_Right ? kKeyStep : -kKeyStep));
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace lodestone
