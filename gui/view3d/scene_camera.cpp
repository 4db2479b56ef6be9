#include "gui/view3d/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <vtkCamera.h>

#include "gui/view3d/scene_geometry.h"

namespace lodestone {
namespace {

constexpr double kNearestClip = 0.3;     // metres; a wall that the eye stands at
const Vec3 kFirstLook(0.5, 0.75, -0.6);  // from the south-west, half from above

/// Finds the least depth at which any of the spheres around boxes enters a camera's picture.
class NearestSphere {
 public:
  explicit NearestSphere(const Camera& camera)
      : frame_(frameOf(camera)),
        tanY_(std::tan(camera.fov * std::numbers::pi / 360)),
        tanX_(tanY_ * camera.width / camera.height) {}

  /// `eye` and the box in the same, any, origin.
  void add(const MeshBox& box, const Vec3& eye) {
    if (box.empty()) return;
    const Vec3 low(box.min[0], box.min[1], box.min[2]);
    const Vec3 high(box.max[0], box.max[1], box.max[2]);
    const double radius = (high - low).norm() / 2;
    const Vec3 offset = (low + high) / 2 - eye;
    const double depth = offset.dot(frame_.forward);
    const double reached = depth + radius;
    if (reached < 0 || depth - radius > depth_) return;
    const double side = 1.5 * radius;  // of the slanted planes, generously
    if (std::abs(offset.dot(frame_.right)) - side > reached * tanX_) return;
    if (std::abs(offset.dot(frame_.up)) - side > reached * tanY_) return;
    depth_ = std::min(depth_, depth - radius);
  }
  [[nodiscard]] double depth() const { return depth_; }

 private:
  CameraFrame frame_;
  double tanY_, tanX_;
  double depth_ = std::numeric_limits<double>::infinity();
};

/// The same but for rounding.
bool looksAlike(const Camera& a, const Camera& b) {
  const double close = 1e-6 * reach(a);
  return (a.eye - b.eye).norm() < close && (a.target - b.target).norm() < close && a.fov == b.fov;
}

std::vector<Box3> boxesOf(const NodeMesh& mesh) {
  std::vector<Box3> boxes;
  boxes.reserve(mesh.boxes.size());
  for (const MeshBox& box : mesh.boxes) {
    if (box.empty()) continue;
    boxes.push_back({mesh.anchor + Vec3(box.min[0], box.min[1], box.min[2]),
                     mesh.anchor + Vec3(box.max[0], box.max[1], box.max[2])});
  }
  return boxes;
}

}  // namespace

SceneCamera::SceneCamera() : slant_(kFirstLook) {
  camera_.eye = camera_.target - kFirstLook.normalized() * 200;
}

void SceneCamera::set(const Camera& camera) {
  const int width = camera_.width;
  const int height = camera_.height;
  camera_ = camera;
  setSize(width, height);
}

void SceneCamera::setSize(int width, int height) {
  camera_.width = std::max(width, 1);
  camera_.height = std::max(height, 1);
}

void SceneCamera::setPlan(bool plan) {
  if (plan == plan_) return;
  const double distance = reach(camera_);
  if (plan) slant_ = frameOf(camera_).forward;
  plan_ = plan;
  camera_.eye = camera_.target - (plan ? Vec3(0, 0, -1) : slant_.normalized()) * distance;
}

Vec3 SceneCamera::lookToFit() const {
  if (plan_) return Vec3(0, 0, -1);
  Vec3 direction = frameOf(camera_).forward;
  direction.z() = std::min(direction.z(), -0.15);  // never from below, nor along the ground
  return direction;
}

Camera SceneCamera::fitted(const std::vector<Box3>& boxes) const {
  FrameFit fit(camera_, lookToFit(), plan_);
  for (const Box3& box : boxes) fit.add(box);
  return fit.camera();
}

void SceneCamera::fit(const SceneGeometry* geometry) {
  if (!geometry || geometry->bounds.empty()) return fitTo({});
  std::vector<Box3> all = boxesOf(*geometry->buildings);
  const Camera usual = all.empty() ? camera_ : fitted(withoutStrays(all));
  if (all.empty() || looksAlike(usual, camera_)) {
    if (geometry->context) {
      for (const Box3& box : boxesOf(*geometry->context)) all.push_back(box);
    }
    camera_ = fitted(all);
  } else {
    camera_ = usual;
  }
}

void SceneCamera::fitTo(const Box3& box) {
  FrameFit fit(camera_, lookToFit(), plan_);
  fit.add(box.empty() ? Box3{Vec3(-100, -100, 0), Vec3(100, 100, 30)} : box);
  camera_ = fit.camera();
}

double SceneCamera::nearestDepth(std::span<const DrawnPart> parts) const {
  NearestSphere nearest(camera_);
  for (const DrawnPart& part : parts) {
    const Vec3 eye = camera_.eye - part.mesh.anchor;
    for (const NodeId node : part.nodes) nearest.add(part.mesh.boxes[node - part.mesh.firstNode], eye);
  }
  return nearest.depth();
}

double SceneCamera::farthestDepth(const Box3& box) const {
  if (box.empty()) return 2 * reach(camera_);
  const Vec3 forward = frameOf(camera_).forward;
  double farthest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) ? box.max.x() : box.min.x(), (corner & 2) ? box.max.y() : box.min.y(),
                 (corner & 4) ? box.max.z() : box.min.z());
    farthest = std::max(farthest, (p - camera_.eye).dot(forward));
  }
  return farthest;
}

void SceneCamera::aim(vtkCamera& target, std::span<const DrawnPart> parts, const Box3& everything) const {
  const CameraFrame frame = frameOf(camera_);
  const Vec3 focus = camera_.eye + frame.forward * reach(camera_);
  target.SetPosition(camera_.eye.data());
  target.SetFocalPoint(focus.data());
  target.SetViewUp(frame.up.data());
  target.SetViewAngle(camera_.fov);
  target.SetParallelProjection(plan_);
  target.SetParallelScale(parallelScale(camera_));
  target.SetWindowCenter(2 * jitter_.x() / camera_.width, 2 * jitter_.y() / camera_.height);
  const double farthest = std::max(farthestDepth(everything) * 1.01 + 1, 2 * kNearestClip);
  const double nearest = nearestDepth(parts);
  // Without perspective depths are evenly spread: the eye may stand in front of everything.
  const double front = plan_ ? std::min(nearest, 0.0) : kNearestClip;
  target.SetClippingRange(std::isfinite(nearest)
                              ? std::clamp(nearest * 0.98 - (plan_ ? 1 : 0), front, farthest / 2)
                              : farthest / 1000,
                          farthest);
}

}  // namespace lodestone
