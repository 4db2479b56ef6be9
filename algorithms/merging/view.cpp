#include "algorithms/merging/view.h"

#include <cmath>
#include <numbers>

namespace lodestone {
namespace {

/// Greatest value of n·p over the box.
double greatest(const Vec3& n, const Box3& box) {
  return (n.array() > 0).select(n.array() * box.max.array(), n.array() * box.min.array()).sum();
}

}  // namespace

View::View(const Camera& camera) : eye_(camera.eye), frame_(frameOf(camera)) {
  const double tanY = std::tan(camera.fov * std::numbers::pi / 360);
  const double tanX = tanY * camera.width / camera.height;
  focal_ = camera.height / (2 * tanY);
  inwards_[0] = frame_.forward * tanX - frame_.right;
  inwards_[1] = frame_.forward * tanX + frame_.right;
  inwards_[2] = frame_.forward * tanY - frame_.up;
  inwards_[3] = frame_.forward * tanY + frame_.up;
}

bool View::excludes(const Box3& box) const {
  if (greatest(frame_.forward, box) - frame_.forward.dot(eye_) < kNearPlane) return true;
  for (const Vec3& n : inwards_) {
    if (greatest(n, box) < n.dot(eye_)) return true;
  }
  return false;
}

bool View::cuts(const Box3& box) const {
  const double nearest = -greatest(-frame_.forward, box) - frame_.forward.dot(eye_);
  return nearest < kNearPlane;
}

Vec2 View::project(const Vec3& point) const {
  const Vec3 seen = point - eye_;
  return Vec2(seen.dot(frame_.right), seen.dot(frame_.up)) * (focal_ / seen.dot(frame_.forward));
}

/// Pixels of the face where coordinate `axis` is `at`.
double View::facePixels(const Box3& box, int axis, double at) const {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const auto corner = [&](double pu, double pv) {
    Vec3 p;
    p[axis] = at;
    p[u] = pu;
    p[v] = pv;
    return project(p);
  };
  const Vec2 a = corner(box.min[u], box.min[v]);
  const Vec2 b = corner(box.max[u], box.min[v]);
  const Vec2 c = corner(box.max[u], box.max[v]);
  const Vec2 d = corner(box.min[u], box.max[v]);
  const Vec2 ac = c - a;
  const Vec2 bd = d - b;
  return std::abs(ac.x() * bd.y() - ac.y() * bd.x()) / 2;
}

double View::pixels(const Box3& box) const {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (eye_[axis] < box.min[axis]) sum += facePixels(box, axis, box.min[axis]);
    if (eye_[axis] > box.max[axis]) sum += facePixels(box, axis, box.max[axis]);
  }
  return sum;
}

double View::distance(const Box3& box) const {
  return (eye_ - eye_.cwiseMax(box.min).cwiseMin(box.max)).norm();
}

}  // namespace lodestone
