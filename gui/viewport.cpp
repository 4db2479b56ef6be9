#include "gui/viewport.h"

#include <QKeyEvent>
#include <QSurfaceFormat>

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace lodestone {

struct Viewport::Impl {
  vtkNew<vtkRenderer> renderer;
  CityScene scene{renderer};
};

Viewport::Viewport(QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>()), scene_(&impl_->scene) {}
Viewport::~Viewport() = default;
void Viewport::requestRender() {
  update();
}
QImage Viewport::grabImage() {
  return {};
}
void Viewport::setCamera(const Camera& camera) {
  scene_->setCamera(camera);
}
void Viewport::fit() {
  scene_->fit();
}
void Viewport::fitTo(const Box3& box) {
  scene_->fitTo(box);
}
void Viewport::setPlanView(bool plan) {
  scene_->setPlanView(plan);
}
bool Viewport::isValid() const {
  return false;
}
QString Viewport::problem() const {
  return {};
}
QString Viewport::graphicsInfo() const {
  return {};
}
void Viewport::setDefaultSurfaceFormat() {}
bool Viewport::eventFilter(QObject* watched, QEvent* event) {
  return QWidget::eventFilter(watched, event);
}
void Viewport::keyPressEvent(QKeyEvent* event) {
  QWidget::keyPressEvent(event);
}
void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
}
void Viewport::tellCamera() {
  Q_EMIT cameraChanged(scene_->camera());
}

}  // namespace lodestone
