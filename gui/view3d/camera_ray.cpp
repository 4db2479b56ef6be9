#include "gui/view3d/camera_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

FrameFit::FrameFit(const Camera& like, const Vec3& direction, bool parallel)
    : camera_(like), parallel_(parallel), nearest_(std::numeric_limits<double>::infinity()) {
  camera_.eye = Vec3::Zero();
  camera_.target = direction;
  frame_ = frameOf(camera_);
  constexpr double kUsed = 0.92;  // of the picture
  tanY_ = tangent(like) * kUsed;
  tanX_ = tanY_ * like.width / like.height;
}

void FrameFit::add(const Box3& box) {
  all_.add(box);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) ? box.max.x() : box.min.x(), (corner & 2) ? box.max.y() : box.min.y(),
                 (corner & 4) ? box.max.z() : box.min.z());
    const double x = p.dot(frame_.right);
    const double y = p.dot(frame_.up);
    const double z = p.dot(frame_.forward);
    const double slopeX = parallel_ ? 0 : z * tanX_;
    const double slopeY = parallel_ ? 0 : z * tanY_;
    low_.add(Vec2(x - slopeX, y - slopeY));
    high_.add(Vec2(x + slopeX, y + slopeY));
    nearest_ = std::min(nearest_, z);
  }
}

Camera FrameFit::camera() const {
  // The right plane of the frustum stands at the largest x − z·tan, the left one at the smallest x + z·tan;
  // where both meet is the eye. The direction that meets farther back decides how far.
  const Vec2 right = low_.max;
  const Vec2 left = high_.min;
  const Vec2 middle = (right + left) / 2;
  const Vec2 apart = right - left;
  const double back = std::max(apart.x() / tanX_, apart.y() / tanY_) / 2;
  const double centre = all_.center().dot(frame_.forward);
  const double depth = parallel_ ? centre - std::max(back, 0.5) : std::min(-back, nearest_ - 0.5);
  Camera camera = camera_;
  camera.eye = frame_.right * middle.x() + frame_.up * middle.y() + frame_.forward * depth;
  camera.target = camera.eye + frame_.forward * std::max(centre - depth, 0.5);
  return camera;
}

std::optional<Vec3> meetPlane(const Ray& ray, double z) {
  if (ray.direction.z() == 0) return {};
  const double distance = (z - ray.origin.z()) / ray.direction.z();
  if (distance <= 0) return {};
  return ray.at(distance);
}

}  // namespace lodestone
