#include "gui/surfaces/scene_widget.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <utility>

#include <vtkRenderer.h>

#include "gui/surfaces/picture_average.h"
#include "gui/surfaces/viewport_surface.h"

namespace lodestone {
namespace {

constexpr int kRestBeforeRefining = 250;  // ms without a change
constexpr int kRefinedSamples = 8;
constexpr double kTooSlowToRefine = 700;  // ms a frame: smooth edges are not worth a stutter
constexpr int kRestBeforeHover = 25;      // ms
constexpr double kKeyPan = 0.12;          // of the picture's height
constexpr double kKeyOrbit = 6;           // degrees

}  // namespace

struct SceneWidget::Impl {
  Content content;
  Scene& scene;
  Navigator navigator{scene};
  std::unique_ptr<ViewportSurface> surface;
  Camera told;
  Camera fitted;
  double pixelRatio = 1;  // of the picture's size
  bool toldPlan = false;
  QTimer refineTimer, hoverTimer;
  PictureAverage average;
  bool sampling = false;  // a frame of grabImage() or refine(): not told to anybody
  QPointF pressed, pointer;
  Qt::MouseButton button = Qt::NoButton;
  DragKind dragKind = DragKind::None;
  bool pulling = false;  // a drag that is not the camera's

  explicit Impl(Content given) : content(std::move(given)), scene(*content.scene) {}
  QImage sample(int i, bool shifted);
};

/// Draws one frame of several, the first of them unshifted where it stands alone.
QImage SceneWidget::Impl::sample(int i, bool shifted) {
  const auto [x, y] = PictureAverage::shift(i);
  if (shifted) scene.setJitter(x, y);
  sampling = true;
  QImage picture = surface->drawNow();
  sampling = false;
  scene.setJitter(0, 0);
  return picture;
}

SceneWidget::SceneWidget(Content content, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(std::move(content))) {
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  impl_->surface = makeViewportSurface(impl_->content.renderers,
                                       {[this](QSize pixels, double ratio) { beforeFrame(pixels, ratio); },
                                        [this](double ms) { afterFrame(ms); }},
                                       this);
  if (isValid()) {
    QWidget* widget = impl_->surface->widget();
    widget->installEventFilter(this);
    widget->setFocusProxy(this);
    layout->addWidget(widget);
  } else {
    showProblem();
  }
  impl_->scene.onChange([this] { sceneChanged(); });
  impl_->refineTimer.setSingleShot(true);
  impl_->hoverTimer.setSingleShot(true);
  impl_->hoverTimer.setInterval(kRestBeforeHover);
  connect(&impl_->refineTimer, &QTimer::timeout, this, &SceneWidget::refine);
  connect(&impl_->hoverTimer, &QTimer::timeout, this, [this] { rested(impl_->pointer); });
}

SceneWidget::~SceneWidget() {
  impl_->scene.onChange([] {});
  impl_->surface->widget()->removeEventFilter(this);
  impl_->surface.reset();  // gives the renderer's resources back while the renderer is still there
}

void SceneWidget::setDefaultSurfaceFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(
      0);  // edges are smoothed when the view rests: multi-sampling costs three times as much on a CPU
  QSurfaceFormat::setDefaultFormat(format);
}

bool SceneWidget::isValid() const {
  return impl_->surface->isValid();
}
QString SceneWidget::problem() const {
  return impl_->surface->problem();
}
QString SceneWidget::graphicsInfo() const {
  return impl_->surface->graphicsInfo();
}

void SceneWidget::showProblem() {
  impl_->surface->widget()->hide();
  auto* message =
      new QLabel(tr("<h3>The 3D view needs OpenGL 3.2</h3><p>%1.</p><p>Everything else works. Pictures need "
                    "no graphics driver on the command line: <code>lodestone-cli render</code>, and the "
                    "whole chain is made by <code>lodestone-cli chain</code>.</p>")
                     .arg(problem().toHtmlEscaped()),
                 this);
  message->setAlignment(Qt::AlignCenter);
  message->setWordWrap(true);
  message->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout()->addWidget(message);
}

void SceneWidget::requestRender() {
  if (!isValid()) return;
  impl_->average.clear();
  impl_->surface->requestFrame();
  impl_->refineTimer.start(kRestBeforeRefining);
}

void SceneWidget::sceneChanged() {
  requestRender();
  tellCamera();
}

void SceneWidget::tellCamera() {
  if (const Camera now = camera(); !(impl_->told == now)) {
    impl_->told = now;
    Q_EMIT cameraChanged(impl_->told);
  }
  if (impl_->toldPlan != impl_->scene.planView()) {
    impl_->toldPlan = impl_->scene.planView();
    Q_EMIT planViewChanged(impl_->toldPlan);
  }
}

void SceneWidget::beforeFrame(QSize pixels, double ratio) {
  setPictureSize(pixels, ratio);
  tellCamera();
}

void SceneWidget::setPictureSize(QSize pixels, double ratio) {
  impl_->pixelRatio = ratio;
  impl_->scene.setSize(pixels.width(), pixels.height(), ratio);
}

void SceneWidget::afterFrame(double ms) {
  if (impl_->sampling) return;
  lastFrameMs_ = ms;
  Q_EMIT frameRendered(ms);
}

QImage SceneWidget::grabImage(int samples) {
  if (!isValid()) return {};
  layout()->activate();  // a window that was never shown has not been laid out
  PictureAverage average;
  for (int i = 0; i < std::max(1, samples); ++i) average.add(impl_->sample(i, samples > 1));
  requestRender();
  return average.mean();
}

void SceneWidget::refine() {
  if (!isVisible() || impl_->navigator.dragging() || lastFrameMs_ > kTooSlowToRefine) return;
  PictureAverage& average = impl_->average;
  const QImage picture = impl_->sample(average.count(), true);
  if (picture.isNull()) return;
  average.add(picture);
  if (average.count() < kRefinedSamples) {
    impl_->refineTimer.start(0);  // events come first: any of them starts over
  } else {
    impl_->surface->show(average.mean());
  }
}

Camera SceneWidget::camera() const {
  Camera camera = impl_->scene.camera();
  camera.width = std::max(1, qRound(camera.width / impl_->pixelRatio));
  camera.height = std::max(1, qRound(camera.height / impl_->pixelRatio));
  return camera;
}
bool SceneWidget::planView() const {
  return impl_->scene.planView();
}
void SceneWidget::setCamera(const Camera& camera) {
  impl_->scene.setCamera(camera);
}
void SceneWidget::fit() {
  impl_->scene.fit();
  impl_->fitted = impl_->scene.camera();
}
bool SceneWidget::isFitted() const {
  const Camera now = impl_->scene.camera();
  return now.eye == impl_->fitted.eye && now.target == impl_->fitted.target;
}
void SceneWidget::fitTo(const Box3& box) {
  impl_->scene.fitTo(box);
}
void SceneWidget::setPlanView(bool plan) {
  impl_->scene.setPlanView(plan);
}

void SceneWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const double ratio = devicePixelRatioF();
  setPictureSize(QSize(qRound(width() * ratio), qRound(height() * ratio)), ratio);
  sceneChanged();
}

QPointF SceneWidget::devicePixels(const QPointF& widgetPosition) const {
  return widgetPosition * devicePixelRatioF();
}

bool SceneWidget::eventFilter(QObject* watched, QEvent* event) {
  if (watched != impl_->surface->widget()) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      mousePressed(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::MouseMove:
      mouseMoved(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::MouseButtonRelease:
      mouseReleased(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::MouseButtonDblClick: {
      const QPointF at = devicePixels(static_cast<QMouseEvent*>(event)->position());
      impl_->navigator.centre(at.x(), at.y());
      return true;
    }
    case QEvent::Wheel:
      wheelTurned(*static_cast<QWheelEvent*>(event));
      return true;
    case QEvent::Leave:
      impl_->hoverTimer.stop();
      left();
      return false;
    default:
      return QWidget::eventFilter(watched, event);
  }
}

void SceneWidget::mousePressed(const QMouseEvent& event) {
  setFocus(Qt::MouseFocusReason);
  if (impl_->button != Qt::NoButton) return;  // a second button does not take over
  impl_->button = event.button();
  impl_->pressed = event.position();
  const bool pans = event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::ShiftModifier);
  impl_->dragKind = pans ? DragKind::Pan : DragKind::Orbit;
}

void SceneWidget::mouseMoved(const QMouseEvent& event) {
  const QPointF at = devicePixels(event.position());
  impl_->pointer = at;
  if (impl_->button == Qt::NoButton) {
    impl_->hoverTimer.start();
    return;
  }
  const bool far = (event.position() - impl_->pressed).manhattanLength() >= QApplication::startDragDistance();
  if (!impl_->navigator.dragging() && !impl_->pulling && far) {
    const QPointF from = devicePixels(impl_->pressed);
    left();
    impl_->pulling = impl_->dragKind == DragKind::Orbit && grabbed(from);
    if (!impl_->pulling) impl_->navigator.beginDrag(impl_->dragKind, from.x(), from.y());
  }
  if (impl_->pulling) pulled(at);
  if (impl_->navigator.dragging()) impl_->navigator.drag(at.x(), at.y());
}

void SceneWidget::mouseReleased(const QMouseEvent& event) {
  if (event.button() != impl_->button) return;
  impl_->button = Qt::NoButton;
  if (std::exchange(impl_->pulling, false)) return released();
  if (impl_->navigator.dragging()) {
    impl_->navigator.endDrag();
    requestRender();
    return;
  }
  if (event.button() == Qt::MiddleButton) return;
  clicked(devicePixels(event.position()), event.button(), event.modifiers());
  if (event.button() == Qt::RightButton) Q_EMIT menuRequested(event.globalPosition().toPoint());
}

void SceneWidget::wheelTurned(const QWheelEvent& event) {
  const QPointF at = devicePixels(event.position());
  impl_->navigator.zoom(event.angleDelta().y() / 120.0, at.x(), at.y());
}

void SceneWidget::orbitOrPan(const QKeyEvent& event) {
  const int right = (event.key() == Qt::Key_Right) - (event.key() == Qt::Key_Left);
  const int up = (event.key() == Qt::Key_Up) - (event.key() == Qt::Key_Down);
  if (event.modifiers().testFlag(Qt::ShiftModifier)) {
    impl_->navigator.orbitBy(right * kKeyOrbit, up * kKeyOrbit);
  } else {
    impl_->navigator.panBy(right * kKeyPan, up * kKeyPan);
  }
}

void SceneWidget::keyPressEvent(QKeyEvent* event) {
  const Camera& camera = impl_->scene.camera();
  switch (event->key()) {
    case Qt::Key_F:
      fit();
      break;
    case Qt::Key_P:
      setPlanView(!planView());
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      impl_->navigator.zoom(1, camera.width / 2.0, camera.height / 2.0);
      break;
    case Qt::Key_Minus:
      impl_->navigator.zoom(-1, camera.width / 2.0, camera.height / 2.0);
      break;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      orbitOrPan(*event);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace lodestone
