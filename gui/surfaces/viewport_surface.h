// Where a Viewport's picture comes from.
#pragma once

#include <QImage>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

class QWidget;

namespace lodestone {

using Renderers = std::vector<vtkSmartPointer<vtkRenderer>>;

/// A widget that shows what some renderers draw. Frames are made when asked for; a picture given to show()
/// stays until the next one.
class ViewportSurface {
 public:
  struct Listener {
    std::function<void(QSize devicePixels, double pixelRatio)> beforeFrame;  ///< the size is the next frame's
    std::function<void(double ms)> afterFrame;
  };

  virtual ~ViewportSurface() = default;
  [[nodiscard]] virtual QWidget* widget() = 0;
  /// Asks for a frame; drawn when the event loop comes to it.
  virtual void requestFrame() = 0;
  /// Draws a frame now and gives it back, in device pixels; null without a context.
  [[nodiscard]] virtual QImage drawNow() = 0;
  /// Shows a picture instead of a frame, until the next frame is asked for.
  virtual void show(const QImage& picture) = 0;
  [[nodiscard]] virtual bool isValid() const = 0;
  [[nodiscard]] virtual QString problem() const = 0;
  [[nodiscard]] virtual QString graphicsInfo() const = 0;
};

/// The surface that fits the platform: QOpenGLWidget on a display, surfaceless EGL on `offscreen`.
[[nodiscard]] std::unique_ptr<ViewportSurface> makeViewportSurface(const Renderers& renderers,
                                                                   ViewportSurface::Listener listener,
                                                                   QWidget* parent);

}  // namespace lodestone
