// A scene as a widget: one interface, two ways to the picture.
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <vector>

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "gui/view3d/navigator.h"
#include "gui/view3d/scene.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace lodestone {

/// Shows a Scene and moves its camera. On a display it draws through QOpenGLWidget; on Qt's `offscreen`
/// platform through a surfaceless EGL context, read back into a picture. Without OpenGL 3.2 it says so and
/// names the command line.
///
/// Mouse: left drag orbits, right or middle drag (or Shift and left) pans, wheel zooms to the cursor,
/// double-click centres, click picks, right click asks for a menu. Keys: F fit, P plan view, arrows pan,
/// Shift and arrows orbit, + and − zoom.
class SceneWidget : public QWidget {
  Q_OBJECT

 public:
  /// A scene and the renderers of one window that it fills.
  struct Content {
    std::vector<vtkSmartPointer<vtkRenderer>> renderers;
    std::unique_ptr<Scene> scene;
  };
  explicit SceneWidget(Content content, QWidget* parent = nullptr);
  ~SceneWidget() override;

  /// Asks for a frame; several requests before the next one make one frame. Changes of the scene ask by
  /// themselves.
  void requestRender();
  /// Draws now and gives the picture in device pixels; null when there is no OpenGL. Needs no visible window.
  /// `samples` frames, each shifted by a part of a pixel, are averaged: 1 is what is seen in motion, 8 is
  /// smooth.
  [[nodiscard]] QImage grabImage(int samples = 1);

  /// Its width and height, like those that cameraChanged() tells, are in pixels of the toolkit and not of the
  /// display, so that what a tolerance in pixels lets through is the same on every display.
  [[nodiscard]] Camera camera() const;
  void setCamera(const Camera& camera);
  void fit();
  /// Whether the view is still the one of the last fit(): nobody has chosen another since.
  [[nodiscard]] bool isFitted() const;
  void fitTo(const Box3& box);
  void setPlanView(bool plan);
  [[nodiscard]] bool planView() const;

  /// False when no OpenGL 3.2 context could be had; `problem()` says why, for people.
  [[nodiscard]] bool isValid() const;
  [[nodiscard]] QString problem() const;
  /// "OpenGL 4.5 (Core Profile) Mesa 22.3.6, llvmpipe"; empty before the first frame.
  [[nodiscard]] QString graphicsInfo() const;
  /// Milliseconds that the last frame took to draw.
  [[nodiscard]] double lastFrameMs() const { return lastFrameMs_; }
  [[nodiscard]] QSize sizeHint() const override { return {960, 640}; }

  /// To be called before QApplication is made: the kind of OpenGL context that all scenes need.
  static void setDefaultSurfaceFormat();

 Q_SIGNALS:
  void frameRendered(double ms);
  void cameraChanged(const lodestone::Camera& camera);
  void planViewChanged(bool plan);
  /// A right click, on what was told as clicked before.
  void menuRequested(const QPoint& globalPosition);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

  /// A click that was no drag, device pixels.
  virtual void clicked(const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) = 0;
  /// The cursor rests here; nothing is under it once it left or drags.
  virtual void rested(const QPointF& at) = 0;
  virtual void left() = 0;
  /// A drag of the left button that began here, device pixels: true takes it from the camera. pulled()
  /// follows with each move, and released() at the end.
  virtual bool grabbed(const QPointF& /*at*/) { return false; }
  virtual void pulled(const QPointF& /*at*/) {}
  virtual void released() {}

 private:
  struct Impl;
  void sceneChanged();
  void beforeFrame(QSize pixels, double ratio);
  void afterFrame(double ms);
  void refine();
  void tellCamera();
  void setPictureSize(QSize pixels, double ratio);
  void showProblem();

  void mousePressed(const QMouseEvent& event);
  void mouseMoved(const QMouseEvent& event);
  void mouseReleased(const QMouseEvent& event);
  void wheelTurned(const QWheelEvent& event);
  void orbitOrPan(const QKeyEvent& event);
  [[nodiscard]] QPointF devicePixels(const QPointF& widgetPosition) const;

  std::unique_ptr<Impl> impl_;
  double lastFrameMs_ = 0;
};

}  // namespace lodestone
