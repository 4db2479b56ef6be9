#include "gui/view3d/camera_ray.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lodestone {
namespace {

double tangent(const Camera& camera) {
  return std::tan(camera.fov * std::numbers::pi / 360);
}

}  // namespace

double reach(const Camera& camera) {
  return std::max((camera.target - camera.eye).norm(), 1e-3);
}

double parallelScale(const Camera& camera) {
  return reach(camera) * tangent(camera);
}

Ray rayThrough(const Camera& camera, bool parallel, double x, double y) {
  const CameraFrame frame = frameOf(camera);
  const double right = (2 * x - camera.width) / camera.height;
  const double up = (camera.height - 2 * y) / camera.height;
  if (parallel) {
    const double scale = parallelScale(camera);
    return {camera.eye + (right * frame.right + up * frame.up) * scale, frame.forward};
  }
  return {camera.eye, (frame.forward + (right * frame.right + up * frame.up) * tangent(camera)).normalized()};
}

std::optional<Vec2> projectPoint(const Camera& camera, bool parallel, const Vec3& point) {
  const CameraFrame frame = frameOf(camera);
  const Vec3 offset = point - camera.eye;
  const double depth = offset.dot(frame.forward);
  if (depth <= 0) return {};
  const double scale = parallel ? parallelScale(camera) : depth * tangent(camera);
  return Vec2((offset.dot(frame.right) / scale * camera.height + camera.width) / 2,
              (camera.height - offset.dot(frame.up) / scale * camera.height) / 2);
}

std::optional<Vec3> meetPlane(const Ray& ray, double z) {
  if (ray.direction.z() == 0) return {};
  const double distance = (z - ray.origin.z()) / ray.direction.z();
  if (distance <= 0) return {};
  return ray.at(distance);
}

}  // namespace lodestone
