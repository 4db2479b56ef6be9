#include "gui/city/viewport.h"

#include <QPainter>

#include <vtkRenderer.h>

#include "gui/city/scene_legend.h"

namespace lodestone {
namespace {

constexpr int kLegendMargin = 10;  // to the view's lower left corner

}  // namespace

/// The scene goes into the base, which is made first.
struct Viewport::CityContent {
  vtkSmartPointer<vtkRenderer> renderer = vtkSmartPointer<vtkRenderer>::New();
  std::unique_ptr<CityScene> scene = std::make_unique<CityScene>(renderer);
  CityScene* kept = scene.get();
};

Viewport::Viewport(QWidget* parent) : Viewport(CityContent(), parent) {}

Viewport::Viewport(CityContent content, QWidget* parent)
    : SceneWidget({{content.renderer}, std::move(content.scene)}, parent),
      scene_(content.kept),
      legend_(new SceneLegend(this)) {
  // Not while the frame is being drawn: a widget that appears asks for one.
  connect(this, &SceneWidget::frameRendered, this, &Viewport::showLegend, Qt::QueuedConnection);
}

void Viewport::showLegend() {
  legend_->setEntries(legendOf(*scene_));
  legend_->move(kLegendMargin, height() - legend_->height() - kLegendMargin);
  legend_->raise();
}

void Viewport::resizeEvent(QResizeEvent* event) {
  SceneWidget::resizeEvent(event);
  showLegend();
}

QImage Viewport::picture() {
  QImage image = grabImage();
  showLegend();
  if (image.isNull() || legend_->entries().empty()) return image;
  image.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(&image);
  legend_->render(&painter, legend_->pos(), {}, QWidget::DrawChildren);
  return image;
}

void Viewport::clicked(const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
  const auto found = scene_->pick(at.x(), at.y());
  if (button == Qt::RightButton && !found) return;
  const bool add = (modifiers & (Qt::ControlModifier | Qt::ShiftModifier)) != 0;
  Q_EMIT picked(found ? found->node : kNoNode, add);
}

void Viewport::rested(const QPointF& at) {
  const auto found = scene_->pick(at.x(), at.y());
  setHovered(found ? found->node : kNoNode);
  const auto ground = scene_->groundPoint(at.x(), at.y());
  if (ground) Q_EMIT pointedAt(ground->x(), ground->y(), ground->z());
}

void Viewport::left() {
  setHovered(kNoNode);
}

void Viewport::setHovered(NodeId node) {
  if (hovered_ == node) return;
  hovered_ = node;
  scene_->setHover(node);
  Q_EMIT hovered(node);
}

}  // namespace lodestone
