// What a widget that shows a scene, and whoever moves its camera, need to know of it.
#pragma once

#include <functional>
#include <optional>

#include "gui/view3d/camera_ray.h"

namespace lodestone {

/// How near and how low a camera may go.
struct CameraLimits {
  double leastHeight = 1.7;  ///< of the eye above the ground, metres: a person standing
  double nearest = 3;        ///< metres to what is zoomed at
  double flattest = -20;     ///< degrees below the horizon: looking up at a tower from the street
};

/// The contents of one or more renderers behind one camera. Positions in the picture are device pixels, x
/// right and y down from the top left.
class Scene {
 public:
  Scene() = default;
  virtual ~Scene() = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Width and height of the picture in device pixels, part of the camera; and device pixels a pixel of the
  /// toolkit, for the width of lines.
  virtual void setSize(int width, int height, double pixelRatio = 1) = 0;
  /// Shifts the next frames by parts of a pixel, for smooth edges out of several.
  virtual void setJitter(double x, double y) = 0;

  [[nodiscard]] virtual const Camera& camera() const = 0;
  virtual void setCamera(const Camera& camera) = 0;
  virtual void fit() = 0;
  virtual void fitTo(const Box3& box) = 0;
  virtual void setPlanView(bool plan) = 0;
  [[nodiscard]] virtual bool planView() const = 0;
  [[nodiscard]] virtual CameraLimits limits() const { return {}; }

  /// The ray through a device pixel.
  [[nodiscard]] virtual Ray through(double x, double y) const = 0;
  /// Point of what stands under a device pixel, else of the ground; nothing above the horizon.
  [[nodiscard]] virtual std::optional<Vec3> groundPoint(double x, double y) const = 0;
  [[nodiscard]] virtual Box3 bounds() const = 0;
  [[nodiscard]] virtual double groundHeight() const = 0;

  /// Called when anything asks for a new frame; set by whoever owns the window.
  virtual void onChange(std::function<void()> changed) = 0;
};

}  // namespace lodestone
