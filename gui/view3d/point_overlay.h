// Points drawn as small signs of a fixed size on the screen.
#pragma once

#include <span>

#include <vtkSmartPointer.h>

#include "gui/view3d/palette.h"
#include "model/geometry.h"

class vtkActor;
class vtkRenderer;

namespace lodestone {

/// Shapes differ, so that signs are told apart without colour.
enum class PointShape { Disc, Circle, Square, Cross };

/// One set of points of one colour and shape in a renderer, dark-rimmed.
class PointOverlay {
 public:
  /// `size`: pixels across. Those `onTop` are seen through everything.
  PointOverlay(vtkRenderer* renderer, PointShape shape, double size, bool onTop = false);
  ~PointOverlay();
  PointOverlay(const PointOverlay&) = delete;
  PointOverlay& operator=(const PointOverlay&) = delete;

  void setPoints(std::span<const Vec3> points);
  void setColour(const Rgb& colour);
  void setVisible(bool visible);
  void setPixelRatio(double ratio);

 private:
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> actor_;
  double size_;
};

}  // namespace lodestone
