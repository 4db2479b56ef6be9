#include "gui/surfaces/viewport_surface.h"

#include <QGuiApplication>

#include "gui/surfaces/egl_surface.h"
#include "gui/surfaces/opengl_surface.h"

namespace lodestone {

std::unique_ptr<ViewportSurface> makeViewportSurface(const Renderers& renderers,
                                                     ViewportSurface::Listener listener, QWidget* parent) {
  // QOpenGLWidget crashes on Qt's platforms that have no window system.
  const QString platform = QGuiApplication::platformName();
  if (platform == QLatin1String("offscreen") || platform == QLatin1String("minimal")) {
    return std::make_unique<EglSurface>(renderers, std::move(listener), parent);
  }
  return std::make_unique<OpenGLSurface>(renderers, std::move(listener), parent);
}

}  // namespace lodestone
