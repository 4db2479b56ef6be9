#include "model/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

FrameFit::FrameFit(const Camera& like, const Vec3& direction, bool parallel)
    : camera_(like), parallel_(parallel), nearest_(std::numeric_limits<double>::infinity()) {
  camera_.eye = Vec3::Zero();
  camera_.target = direction;
  frame_ = frameOf(camera_);
  constexpr double kUsed = 0.92;  // of the picture
  tanY_ = std::tan(like.fov * std::numbers::pi / 360) * kUsed;
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

std::vector<Box3> withoutStrays(std::vector<Box3> boxes) {
  std::erase_if(boxes, [](const Box3& box) { return box.empty(); });
  if (boxes.empty()) return boxes;
  std::vector<double> values(boxes.size());
  const auto nth = [&](std::size_t rank, const auto& valueOf) {
    std::transform(boxes.begin(), boxes.end(), values.begin(), valueOf);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
    return values[rank];
  };
  const Vec2 middle(nth(boxes.size() / 2, [](const Box3& box) { return box.center().x(); }),
                    nth(boxes.size() / 2, [](const Box3& box) { return box.center().y(); }));
  const auto distance = [&](const Box3& box) { return (box.center().head<2>() - middle).norm(); };
  const double usual = nth((boxes.size() * 19 - 1) / 20, distance);
  std::erase_if(boxes, [&](const Box3& box) { return distance(box) > 1.5 * usual; });
  return boxes;
}

Camera fitCamera(const Box3& box, const Vec3& direction, double fov, int width, int height) {
  Camera like;
  like.fov = fov;
  like.width = width;
  like.height = height;
  FrameFit fit(like, direction, false);
  fit.add(box.empty() ? Box3{Vec3(-1, -1, -1), Vec3(1, 1, 1)} : box);
  return fit.camera();
}

}  // namespace lodestone
