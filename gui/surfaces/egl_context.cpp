#include "gui/surfaces/egl_context.h"

#include <array>

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace lodestone {
namespace {

EGLDisplay surfacelessDisplay() {
  const auto getDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (!getDisplay) return EGL_NO_DISPLAY;
  const EGLDisplay display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_DISPLAY;
  return display;
}

EGLConfig firstConfig(EGLDisplay display) {
  constexpr std::array<EGLint, 5> kWanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                          EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display, kWanted.data(), &config, 1, &count);
  return count > 0 ? config : nullptr;
}

}  // namespace

EglContext::EglContext() {
  open();
  if (!context_) problem_ = "no surfaceless EGL context with OpenGL 3.2 (Mesa's EGL library gives one)";
}

void EglContext::open() {
  display_ = surfacelessDisplay();
  if (display_ == EGL_NO_DISPLAY || !eglBindAPI(EGL_OPENGL_API)) return;
  const EGLConfig config = firstConfig(display_);
  if (!config) return;
  constexpr std::array<EGLint, 7> kVersion{EGL_CONTEXT_MAJOR_VERSION,
                                           3,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           2,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_NONE};
  constexpr std::array<EGLint, 5> kSize{EGL_WIDTH, 16, EGL_HEIGHT, 16,
                                        EGL_NONE};  // drawing goes to framebuffer objects
  context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, kVersion.data());
  surface_ = eglCreatePbufferSurface(display_, config, kSize.data());
}

EglContext::~EglContext() {
  if (!context_) return;
  if (isCurrent()) doneCurrent();
  eglDestroySurface(display_, surface_);
  eglDestroyContext(display_, context_);
}

void EglContext::makeCurrent() {
  if (context_ && !isCurrent()) eglMakeCurrent(display_, surface_, surface_, context_);
}

void EglContext::doneCurrent() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

bool EglContext::isCurrent() const {
  return context_ && eglGetCurrentContext() == context_;
}

}  // namespace lodestone
