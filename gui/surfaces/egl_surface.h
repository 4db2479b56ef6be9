// The picture without a display: drawn by EGL, read back, painted like any other image.
#pragma once

#include <QImage>
#include <QWidget>

#include <vtkNew.h>

#include "gui/surfaces/egl_context.h"
#include "gui/surfaces/viewport_surface.h"
#include "gui/view3d/gl_window.h"

namespace lodestone {

class EglSurface final : public QWidget, public ViewportSurface {
  Q_OBJECT

 public:
  EglSurface(const Renderers& renderers, Listener listener, QWidget* parent);
  ~EglSurface() override;

  QWidget* widget() override { return this; }
  void requestFrame() override;
  QImage drawNow() override;
  void show(const QImage& picture) override;
  bool isValid() const override { return problem_.isEmpty(); }
  QString problem() const override { return problem_; }
  QString graphicsInfo() const override { return info_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  EglContext context_;
  vtkNew<GlWindow> window_;
  Listener listener_;
  QString problem_;
  QString info_;
  QImage picture_;
  bool stale_ = true;
};

}  // namespace lodestone
