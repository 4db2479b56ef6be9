// Lines over and beside the city: streets, outlines of merged hulls, boxes of negative space.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include <vtkSmartPointer.h>

#include "gui/view3d/palette.h"
#include "model/geometry.h"

class vtkActor;
class vtkRenderer;

namespace lodestone {

/// Line segments of one set, each end a point in local metres, with a colour of its own.
struct LineSegments {
  std::vector<std::array<Vec3, 2>> segments;
  std::vector<Rgb> colours;  ///< of each segment
  void add(const Vec3& a, const Vec3& b, const Rgb& colour) {
    segments.push_back({a, b});
    colours.push_back(colour);
  }
};

/// One set of lines in a renderer.
class LineOverlay {
 public:
  LineOverlay(vtkRenderer* renderer, double width, double opacity);
  ~LineOverlay();
  LineOverlay(const LineOverlay&) = delete;
  LineOverlay& operator=(const LineOverlay&) = delete;

  void setLines(const LineSegments& lines);
  void setVisible(bool visible);
  void setOpacity(double opacity);
  void setPixelRatio(double ratio);

 private:
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> actor_;
  double width_;
};

}  // namespace lodestone
