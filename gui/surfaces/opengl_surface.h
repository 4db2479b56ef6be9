// The picture on a display, through QOpenGLWidget.
#pragma once

#include <QOpenGLWidget>

#include <vtkNew.h>

#include "gui/surfaces/viewport_surface.h"
#include "gui/view3d/gl_window.h"

namespace lodestone {

class OpenGLSurface final : public QOpenGLWidget, public ViewportSurface {
  Q_OBJECT

 public:
  OpenGLSurface(const Renderers& renderers, Listener listener, QWidget* parent);
  ~OpenGLSurface() override;

  /// Empty when a context with OpenGL 3.2 can be had, else why not.
  [[nodiscard]] static QString probe();

  QWidget* widget() override { return this; }
  void requestFrame() override;
  QImage drawNow() override;
  void show(const QImage& picture) override;
  bool isValid() const override { return problem_.isEmpty(); }
  QString problem() const override { return problem_; }
  QString graphicsInfo() const override { return info_; }

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  void loseContext();
  void drawFrame();
  void copyToWidget();

  vtkNew<GlWindow> window_;
  QMetaObject::Connection contextGoes_;
  Listener listener_;
  QString problem_;
  QString info_;
  QImage shown_;  // instead of a frame, when not null
};

}  // namespace lodestone
