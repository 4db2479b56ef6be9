// What a camera sees of axis-aligned boxes.
#pragma once

#include "model/camera.h"

namespace lodestone {

/// Metres in front of the eye at which the picture begins.
inline constexpr double kNearPlane = 0.1;

class View {
 public:
  explicit View(const Camera& camera);

  /// True when the box lies wholly outside one of the picture's four sides or before the near plane. Never
  /// true for a box inside one for which it is not: so whole subtrees can be judged by their boxes.
  [[nodiscard]] bool excludes(const Box3& box) const;
  /// True when the near plane cuts the box, or the eye is in it. \pre it is not excluded.
  [[nodiscard]] bool cuts(const Box3& box) const;
  /// Pixels that the sides of the box which face the camera cover, not clipped to the picture. \pre not cut.
  [[nodiscard]] double pixels(const Box3& box) const;
  /// Metres from the eye to the nearest point of the box.
  [[nodiscard]] double distance(const Box3& box) const;
  /// Metres at `distance` metres that make one pixel.
  [[nodiscard]] double metresPerPixel(double distance) const { return distance / focal_; }

 private:
  [[nodiscard]] Vec2 project(const Vec3& point) const;
  [[nodiscard]] double facePixels(const Box3& box, int axis, double at) const;

  Vec3 eye_;
  CameraFrame frame_;
  double focal_;     ///< pixels
  Vec3 inwards_[4];  ///< normals of the picture's sides
};

}  // namespace lodestone
