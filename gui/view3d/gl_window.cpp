#include "gui/view3d/gl_window.h"

#include <array>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>
#include <vtk_glew.h>

namespace lodestone {

vtkStandardNewMacro(GlWindow);

GlWindow::GlWindow() {
  SetReadyForRendering(false);  // nothing may be drawn before beginContext()
  SetOwnContext(0);
  SetFrameBlitModeToNoBlit();
  SetMultiSamples(0);
  const auto observe = [this](unsigned long event, void (*answer)(vtkObject*, unsigned long, void*, void*)) {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(answer);
    AddObserver(event, command);
  };
  observe(vtkCommand::WindowMakeCurrentEvent,
          [](vtkObject*, unsigned long, void* self, void*) { static_cast<GlWindow*>(self)->makeCurrent_(); });
  observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* self, void* answer) {
    *static_cast<bool*>(answer) = static_cast<GlWindow*>(self)->isCurrent_();
  });
  observe(vtkCommand::WindowSupportsOpenGLEvent,
          [](vtkObject*, unsigned long, void*, void* answer) { *static_cast<int*>(answer) = 1; });
}

void GlWindow::setContext(std::function<void()> makeCurrent, std::function<bool()> isCurrent) {
  makeCurrent_ = std::move(makeCurrent);
  isCurrent_ = std::move(isCurrent);
}

bool GlWindow::beginContext() {
  SetReadyForRendering(true);
  OpenGLInitContext();
  if (!Initialized) {
    SetReadyForRendering(false);
    return false;
  }
  GetState()->Reset();
  GetState()->vtkglDepthFunc(GL_LEQUAL);  // Qt leaves GL_LESS, VTK takes LEQUAL for granted
  return true;
}

void GlWindow::endContext() {
  if (!GetReadyForRendering()) return;
  Finalize();           // the resources of all renderers and props
  Initialized = false;  // so that the next context is looked at again
  SetReadyForRendering(false);
}

void GlWindow::OpenGLInitContext() {
  ContextCreationTime.Modified();
  if (Initialized) return;
  const GLenum result = glewInit();
  GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
  if (!GlewInitValid || !GLEW_VERSION_3_2) return;
  Initialized = true;
  std::array<GLfloat, 2> range{1, 1};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range.data());
  MaximumHardwareLineWidth = range[1] > 0 ? range[1] : 1;
}

}  // namespace lodestone
