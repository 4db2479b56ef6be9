// The rays of a camera's pixels.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "algorithms/rendering/ray_scene.h"
#include "model/camera.h"

namespace lodestone {

/// Four rays a pixel, in coordinates relative to an origin near what is looked at.
class CameraRays {
 public:
  static constexpr std::size_t kSamples = 4;

  CameraRays(const Camera& camera, const Vec3& origin)
      : camera_(camera),
        frame_(frameOf(camera)),
        half_(std::tan(camera.fov * std::numbers::pi / 360)),
        eye_((camera.eye - origin).cast<float>()) {}

  [[nodiscard]] const Vec3f& eye() const { return eye_; }
  /// With a unit direction.
  [[nodiscard]] Ray through(int x, int y, std::size_t sample) const {
    const double right = (2 * (x + kPlaces[sample][0]) - camera_.width) / camera_.height * half_;
    const double up = (1 - 2 * (y + kPlaces[sample][1]) / camera_.height) * half_;
    return {eye_, (frame_.forward + frame_.right * right + frame_.up * up).normalized().cast<float>()};
  }
  [[nodiscard]] RayBundle through(int x, int y) const {
    return {through(x, y, 0), through(x, y, 1), through(x, y, 2), through(x, y, 3)};
  }
  /// Between the middles of two samples beside each other, at one unit from the eye.
  [[nodiscard]] float spread() const { return static_cast<float>(half_ / camera_.height); }

 private:
  /// In the pixel: a 2 × 2 grid turned, so that near-horizontal and near-vertical edges get four steps.
  static constexpr std::array<std::array<double, 2>, kSamples> kPlaces{
      {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}};

  Camera camera_;
  CameraFrame frame_;
  double half_;
  Vec3f eye_;
};

}  // namespace lodestone
