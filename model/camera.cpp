#include "model/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace lodestone {

CameraFrame frameOf(const Camera& camera) {
  Vec3 forward = camera.target - camera.eye;
  if (forward.norm() == 0) forward = -Vec3::UnitZ();
  forward.normalize();
  const bool vertical = std::abs(forward.z()) > 1 - 1e-9;
  const Vec3 reference = vertical ? Vec3::UnitY() : Vec3::UnitZ();
  const Vec3 right = forward.cross(reference).normalized();
  return {right, right.cross(forward).normalized(), forward};
}

Camera fitCamera(const Box3& box, const Vec3& direction, double fov, int width, int height) {
  Camera camera;
  camera.fov = fov;
  camera.width = width;
  camera.height = height;
  camera.target = box.empty() ? Vec3(0, 0, 0) : box.center();
  camera.eye = camera.target - direction.normalized();
  const CameraFrame frame = frameOf(camera);
  const double tanY = std::tan(fov * std::numbers::pi / 360);
  const double tanX = tanY * width / height;
  const Vec3 half = box.empty() ? Vec3(1, 1, 1) : (box.size() / 2).eval();
  double distance = 1e-3;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) ? half.x() : -half.x(), (corner & 2) ? half.y() : -half.y(),
                 (corner & 4) ? half.z() : -half.z());
    const double depth = p.dot(frame.forward);
    distance = std::max(
        {distance, std::abs(p.dot(frame.right)) / tanX - depth, std::abs(p.dot(frame.up)) / tanY - depth});
  }
  constexpr double kMargin = 1.05;
  camera.eye = camera.target - frame.forward * distance * kMargin;
  return camera;
}

}  // namespace lodestone
