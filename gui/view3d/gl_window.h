// VTK's render window inside somebody else's OpenGL context.
#pragma once

#include <functional>

#include <vtkGenericOpenGLRenderWindow.h>

namespace lodestone {

/// The context belongs to a widget or to EGL: it is told how to make it current and how to ask whether it is.
/// Debian's GLEW is built for GLX and says "no GLX display" for contexts made by EGL or Wayland, with all
/// functions loaded: that is no error here.
class GlWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static GlWindow* New();
  vtkTypeMacro(GlWindow, vtkGenericOpenGLRenderWindow)

      void setContext(std::function<void()> makeCurrent, std::function<bool()> isCurrent);
  /// To be called when a context is there and current. False without OpenGL 3.2.
  bool beginContext();
  /// To be called while the context that is about to go is current: gives back all its resources.
  void endContext();

  void OpenGLInitContext() override;

 protected:
  GlWindow();
  ~GlWindow() override = default;

 private:
  GlWindow(const GlWindow&) = delete;
  void operator=(const GlWindow&) = delete;

  std::function<void()> makeCurrent_ = [] {};
  std::function<bool()> isCurrent_ = [] { return false; };
};

}  // namespace lodestone
