// A pinhole camera, in local metres.
#pragma once

#include <vector>

#include "model/geometry.h"

namespace lodestone {

/// Up is z; looking straight down (or up), the top of the picture is north.
struct Camera {
  Vec3 eye = Vec3(0, -100, 100);
  Vec3 target = Vec3::Zero();
  double fov = 45;  ///< vertical field of view, degrees
  int width = 1280;
  int height = 800;
  bool operator==(const Camera&) const = default;
};

/// Orthonormal axes of a camera: right, up (in the picture), forward.
struct CameraFrame {
  Vec3 right, up, forward;
};
[[nodiscard]] CameraFrame frameOf(const Camera& camera);

/// The nearest camera in a direction that sees all boxes added, with 4% of the picture to spare on each side.
/// Exact: the planes of the frustum touch what was added.
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

/// The boxes worth looking at first: without those that stand more than 1.5 times as far from the middle (the
/// median, in plan) as 19 of 20 boxes do. Empty boxes are left out. Cost: O(boxes).
[[nodiscard]] std::vector<Box3> withoutStrays(std::vector<Box3> boxes);

/// A camera that sees the whole box from `direction` (towards the scene; need not be unit).
[[nodiscard]] Camera fitCamera(const Box3& box, const Vec3& direction, double fov = 45, int width = 1280,
                               int height = 800);

}  // namespace lodestone
