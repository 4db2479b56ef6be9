#include "gui/surfaces/opengl_surface.h"

#include <QElapsedTimer>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QPainter>

#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

namespace lodestone {

OpenGLSurface::OpenGLSurface(const Renderers& renderers, Listener listener, QWidget* parent)
    : QOpenGLWidget(parent), listener_(std::move(listener)), problem_(probe()) {
  setMouseTracking(true);
  setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
  for (const auto& renderer : renderers) window_->AddRenderer(renderer);
  // makeCurrent() binds the widget's framebuffer anew, which would blank the view: only where it is not
  // current.
  window_->setContext(
      [this] {
        if (QOpenGLContext::currentContext() != context()) makeCurrent();
      },
      [this] { return context() && QOpenGLContext::currentContext() == context(); });
}

OpenGLSurface::~OpenGLSurface() {
  loseContext();
  disconnect(contextGoes_);  // Qt destroys the context when this part of the object is gone
}

QString OpenGLSurface::probe() {
  // Asked once: the answer does not change while the program runs.
  static const QString answer = [] {
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface))
      return QStringLiteral("no OpenGL context could be made");
    const auto [major, minor] = context.format().version();
    const bool enough = major > 3 || (major == 3 && minor >= 2);
    context.doneCurrent();
    return enough ? QString() : QStringLiteral("the driver offers OpenGL %1.%2 only").arg(major).arg(minor);
  }();
  return answer;
}

void OpenGLSurface::initializeGL() {
  // Qt makes a new context each time that the widget changes its window: docked, floated, docked again.
  disconnect(contextGoes_);
  contextGoes_ = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &OpenGLSurface::loseContext);
  if (!window_->beginContext()) problem_ = QStringLiteral("OpenGL 3.2 is missing");
  auto* gl = context()->functions();
  const auto said = [gl](unsigned name) {
    return QString::fromLatin1(reinterpret_cast<const char*>(gl->glGetString(name)));
  };
  info_ = QStringLiteral("OpenGL %1, %2").arg(said(GL_VERSION), said(GL_RENDERER));
}

void OpenGLSurface::loseContext() {
  if (!window_->GetReadyForRendering() || !context()) return;
  makeCurrent();
  window_->endContext();
  doneCurrent();
}

void OpenGLSurface::requestFrame() {
  shown_ = QImage();
  update();
}

void OpenGLSurface::show(const QImage& picture) {
  shown_ = picture;
  update();
}

QImage OpenGLSurface::drawNow() {
  if (!isValid()) return {};
  shown_ = QImage();
  return grabFramebuffer().convertToFormat(QImage::Format_RGB32);
}

void OpenGLSurface::paintGL() {
  if (!window_->GetReadyForRendering()) return;
  if (shown_.isNull()) {
    drawFrame();
  } else {
    QPainter(this).drawImage(QRect(QPoint(), size()), shown_);
  }
}

void OpenGLSurface::drawFrame() {
  QElapsedTimer timer;
  timer.start();
  const double ratio = devicePixelRatioF();
  const QSize pixels(std::max(1, qRound(width() * ratio)), std::max(1, qRound(height() * ratio)));
  window_->SetDPI(qRound(72 * ratio));
  window_->SetSize(pixels.width(), pixels.height());
  listener_.beforeFrame(pixels, ratio);
  vtkOpenGLState& state = *window_->GetState();
  state.Reset();
  state.Push();
  state.vtkglDepthFunc(GL_LEQUAL);
  window_->Render();
  makeCurrent();
  copyToWidget();
  state.Pop();
  context()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  context()->functions()->glFinish();
  listener_.afterFrame(static_cast<double>(timer.nsecsElapsed()) / 1e6);
}

void OpenGLSurface::copyToWidget() {
  auto* gl = context()->extraFunctions();
  const int* size = window_->GetSize();
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  const GLenum target = GL_COLOR_ATTACHMENT0;
  gl->glDrawBuffers(1, &target);
  gl->glDisable(GL_SCISSOR_TEST);
  window_->BlitDisplayFramebuffer(0, 0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT,
                                  GL_NEAREST);
  // Opaque, or Qt would let the desktop shine through.
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace lodestone
