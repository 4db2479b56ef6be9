#include "algorithms/perception/viewpoints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lodestone {
namespace {

constexpr double kFov = 45;         // degrees
constexpr double kEyeHeight = 1.7;  // metres: a person's
/// Viewpoints that are 13° apart: a slit that only shows between two of them hides next to nothing.
constexpr int kCloser = 250;
constexpr double kUsed = 0.92;     // of the opening
constexpr double kWidthsAway = 2;  // of the box in plan

/// Fibonacci's lattice: each direction stands for an equal share of the sphere, or of its upper half.
Vec3 spreadDirection(int i, const PerceiveOptions& options, double turn) {
  const double share = (i + 0.5) / options.views;
  const double z = options.viewpoints == ViewpointSet::Upper ? 1 - share : 1 - 2 * share;
  const double angle = 2 * std::numbers::pi * (i * (std::numbers::phi - 1) + turn);
  const double flat = std::sqrt(std::max(0.0, 1 - z * z));
  return {flat * std::cos(angle), flat * std::sin(angle), z};
}

/// As near as shows the whole box, but two widths away at least: nobody looks at a house from its doormat.
Camera streetCamera(const Box3& box, double share, const PerceiveOptions& options) {
  const double angle = 2 * std::numbers::pi * share;
  const double half = box.size().head<2>().norm() / 2;
  const double height = box.size().z();
  const double eye = std::min(kEyeHeight, height / 2);
  // Half of what is above the eye, as seen by a camera that looks at the middle of the box, is on either
  // side.
  const double tangent = std::tan(kUsed * kFov / 2 * std::numbers::pi / 180);
  const double away = half + std::max({kWidthsAway * 2 * half, half / tangent, height / tangent, kEyeHeight});
  Camera camera{.fov = kFov, .width = options.size, .height = options.size};
  camera.eye = box.center() + away * Vec3(std::cos(angle), std::sin(angle), 0);
  camera.eye.z() = box.min.z() + eye;
  camera.target = box.center();
  return camera;
}

}  // namespace

std::vector<Camera> viewpointsAround(const Box3& box, const PerceiveOptions& options, double turn) {
  std::vector<Camera> cameras;
  if (box.empty()) return cameras;
  for (int i = 0; i < options.views; ++i) {
    if (options.viewpoints == ViewpointSet::Street)
      cameras.push_back(streetCamera(box, (i + turn) / options.views, options));
    else
      cameras.push_back(fitCamera(box, -spreadDirection(i, options, turn), kFov, options.size, options.size));
  }
  return cameras;
}

std::vector<Vec3> closerViewpoints(const Box3& box, const PerceiveOptions& options) {
  PerceiveOptions many = options;
  many.views = std::max(kCloser, options.views);
  std::vector<Vec3> eyes;
  for (const Camera& camera : viewpointsAround(box, many, 0.25)) eyes.push_back(camera.eye);
  return eyes;
}

}  // namespace lodestone
