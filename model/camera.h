// A pinhole camera, in local metres.
#pragma once

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

/// A camera that sees the whole box from `direction` (towards the scene; need not be unit), 5% margin.
[[nodiscard]] Camera fitCamera(const Box3& box, const Vec3& direction, double fov = 45, int width = 1280,
                               int height = 800);

}  // namespace lodestone
