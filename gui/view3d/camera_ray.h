// Pixels to rays and back: the geometry of the picture without the GPU.
#pragma once

#include <optional>

#include "model/camera.h"

namespace lodestone {

struct Ray {
  Vec3 origin = Vec3::Zero();
  Vec3 direction = Vec3::UnitX();  ///< unit
  [[nodiscard]] Vec3 at(double distance) const { return origin + direction * distance; }
};

/// Metres from eye to target, never 0.
[[nodiscard]] double reach(const Camera& camera);
/// Half the height of what a parallel camera shows, metres: as much as the perspective one sees at its
/// target.
[[nodiscard]] double parallelScale(const Camera& camera);

/// The ray through a pixel position (x right, y down from the top left; pixel centres are at halves).
[[nodiscard]] Ray rayThrough(const Camera& camera, bool parallel, double x, double y);
/// Pixel position of a point; nothing when it is not in front of the eye.
[[nodiscard]] std::optional<Vec2> projectPoint(const Camera& camera, bool parallel, const Vec3& point);
/// Where a ray meets the horizontal plane at `z`; nothing when it does not.
[[nodiscard]] std::optional<Vec3> meetPlane(const Ray& ray, double z);

/// The nearest camera in a direction that sees all boxes added, with 4% of the picture to spare on each side.
/// Exact: where fitCamera() goes by the corners of one box around everything, this one fits what is really
/// there.
class FrameFit {
 public:
  /// Field of view and size are those of `like`. \pre the direction is not zero.
  FrameFit(const Camera& like, const Vec3& direction, bool parallel);
  void add(const Box3& box);
  /// \pre a box was added.
  [[nodiscard]] Camera camera() const;

 private:
  Camera camera_;
  CameraFrame frame_;
  bool parallel_;
  double tanX_;
  double tanY_;
  // Bounds of x ± z·tan of all corners, in the frame's axes: the planes of the frustum that touch them.
  Box2 low_, high_;
  double nearest_;
  Box3 all_;
};

}  // namespace lodestone
