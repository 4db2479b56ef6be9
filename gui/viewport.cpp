#include "gui/viewport.h"

#include <vtkRenderer.h>

namespace lodestone {

/// The scene goes into the base, which is made first.
struct Viewport::CityContent {
  vtkSmartPointer<vtkRenderer> renderer = vtkSmartPointer<vtkRenderer>::New();
  std::unique_ptr<CityScene> scene = std::make_unique<CityScene>(renderer);
  CityScene* kept = scene.get();
};

Viewport::Viewport(QWidget* parent) : Viewport(CityContent(), parent) {}

Viewport::Viewport(CityContent content, QWidget* parent)
    : SceneWidget({{content.renderer}, std::move(content.scene)}, parent), scene_(content.kept) {}

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
