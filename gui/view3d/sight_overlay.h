// A viewpoint as it is drawn in one pane.
#pragma once

#include <optional>

#include <vtkSmartPointer.h>

#include "gui/view3d/overlays.h"
#include "gui/view3d/palette.h"
#include "gui/view3d/point_overlay.h"
#include "gui/view3d/sight_fan.h"

class vtkActor;
class vtkRenderer;

namespace lodestone {

/// The fan on the ground, tinted and outlined, a pole up to the eye, and the handles.
class SightOverlay {
 public:
  explicit SightOverlay(vtkRenderer* renderer);
  ~SightOverlay();
  SightOverlay(const SightOverlay&) = delete;
  SightOverlay& operator=(const SightOverlay&) = delete;

  /// Nothing: hides it.
  void show(const std::optional<SightOptions>& sight, const Palette& palette);
  void setPixelRatio(double ratio);

 private:
  void showArea(const SightOptions& sight, const Palette& palette);

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> area_;
  LineOverlay lines_;
  PointOverlay eye_, foot_, handles_;
};

}  // namespace lodestone
