#include "gui/surfaces/egl_surface.h"

#include <QElapsedTimer>
#include <QPainter>

#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace lodestone {
namespace {

QString shortInfo(const char* capabilities) {
  const QString all = QString::fromLatin1(capabilities);
  const auto after = [&all](const QString& key) {
    return all.section(key, 1).section(QLatin1Char('\n'), 0, 0).trimmed();
  };
  return QStringLiteral("OpenGL %1, %2 (EGL)")
      .arg(after(QStringLiteral("OpenGL version string:")), after(QStringLiteral("OpenGL renderer string:")));
}

}  // namespace

EglSurface::EglSurface(const Renderers& renderers, Listener listener, QWidget* parent)
    : QWidget(parent), listener_(std::move(listener)), problem_(QString::fromStdString(context_.problem())) {
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  for (const auto& renderer : renderers) window_->AddRenderer(renderer);
  window_->setContext([this] { context_.makeCurrent(); }, [this] { return context_.isCurrent(); });
  if (!context_.isValid()) return;
  context_.makeCurrent();
  if (!window_->beginContext()) problem_ = QStringLiteral("OpenGL 3.2 is missing");
}

EglSurface::~EglSurface() {
  context_.makeCurrent();
  window_->endContext();
}

void EglSurface::requestFrame() {
  stale_ = true;
  update();
}

void EglSurface::show(const QImage& picture) {
  picture_ = picture;
  stale_ = false;
  update();
}

QImage EglSurface::drawNow() {
  if (!isValid()) return {};
  QElapsedTimer timer;
  timer.start();
  const double ratio = devicePixelRatioF();
  const QSize pixels(std::max(1, qRound(width() * ratio)), std::max(1, qRound(height() * ratio)));
  context_.makeCurrent();
  window_->SetDPI(qRound(72 * ratio));
  window_->SetSize(pixels.width(), pixels.height());
  listener_.beforeFrame(pixels, ratio);
  window_->Render();
  if (info_.isEmpty()) info_ = shortInfo(window_->ReportCapabilities());
  vtkNew<vtkUnsignedCharArray> rgba;
  window_->GetRGBACharPixelData(0, 0, pixels.width() - 1, pixels.height() - 1, 0, rgba);
  const QImage upsideDown(rgba->GetPointer(0), pixels.width(), pixels.height(), pixels.width() * 4,
                          QImage::Format_RGBX8888);
  picture_ = upsideDown.mirrored().convertToFormat(QImage::Format_RGB32);
  picture_.setDevicePixelRatio(ratio);
  stale_ = false;
  listener_.afterFrame(static_cast<double>(timer.nsecsElapsed()) / 1e6);
  return picture_;
}

void EglSurface::paintEvent(QPaintEvent*) {
  if (stale_) (void)drawNow();
  QPainter painter(this);
  if (!picture_.isNull()) painter.drawImage(rect(), picture_);
}

void EglSurface::resizeEvent(QResizeEvent* event) {
  stale_ = true;
  QWidget::resizeEvent(event);
}

}  // namespace lodestone
