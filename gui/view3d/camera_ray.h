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

}  // namespace lodestone
