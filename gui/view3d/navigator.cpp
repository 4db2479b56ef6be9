#include "gui/view3d/navigator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "gui/view3d/scene.h"

namespace lodestone {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kSteepest = 89.9;          // degrees below the horizon
constexpr double kZoomStep = 0.84;          // distance after one notch
constexpr double kDegreesPerPicture = 200;  // orbit of a drag across the whole picture

/// Degrees below the horizon that the camera looks.
double pitchOf(const Camera& camera) {
  const Vec3 forward = (camera.target - camera.eye).normalized();
  return -std::asin(std::clamp(forward.z(), -1.0, 1.0)) / kRadians;
}

}  // namespace

void Navigator::beginDrag(DragKind kind, double x, double y) {
  kind_ = kind == DragKind::Orbit && scene_.planView() ? DragKind::Pan : kind;
  last_ = Vec2(x, y);
  pivot_ = scene_.groundPoint(x, y).value_or(scene_.camera().target);
}

void Navigator::drag(double x, double y) {
  const Vec2 moved = Vec2(x, y) - last_;
  last_ = Vec2(x, y);
  if (kind_ == DragKind::Orbit) {
    const double degrees = kDegreesPerPicture / std::max(scene_.camera().height, 1);
    orbitAbout(pivot_, -moved.x() * degrees, moved.y() * degrees);
  } else if (kind_ == DragKind::Pan) {
    const auto under = onPlane(x, y, pivot_.z());
    if (under) moveBy(pivot_ - *under);
  }
}

void Navigator::zoom(double steps, double x, double y) {
  Camera camera = scene_.camera();
  const Vec3 towards = scene_.groundPoint(x, y).value_or(camera.target);
  double factor = std::pow(kZoomStep, steps);
  if (!scene_.planView()) {
    const double distance = (camera.eye - towards).norm();
    const double farthest = 20 * std::max(scene_.bounds().size().norm(), 33 * scene_.limits().nearest);
    factor = std::clamp(distance * factor, std::min(scene_.limits().nearest, distance),
                        std::max(farthest, distance)) /
             std::max(distance, 1e-9);
  }
  camera.eye = towards + (camera.eye - towards) * factor;
  camera.target = towards + (camera.target - towards) * factor;
  if (scene_.planView()) {
    // A plan keeps its eye above everything: the distance to the target alone is the scale.
    const double height = std::max(reach(scene_.camera()) * factor, scene_.limits().nearest);
    camera.target.z() = scene_.groundHeight();
    camera.eye.z() = camera.target.z() + height;
  }
  scene_.setCamera(camera);
}

void Navigator::centre(double x, double y) {
  const auto point = scene_.groundPoint(x, y);
  if (!point) return;
  Camera camera = scene_.camera();
  const Vec3 offset = camera.eye - camera.target;
  camera.target = *point;
  camera.eye = *point + offset;
  camera.eye.z() = std::max(camera.eye.z(), scene_.groundHeight() + scene_.limits().leastHeight);
  scene_.setCamera(camera);
}

void Navigator::panBy(double right, double up) {
  const Camera& camera = scene_.camera();
  const CameraFrame frame = frameOf(camera);
  const Vec3 ahead = frame.forward + frame.up;
  const Vec3 heading = Vec3(ahead.x(), ahead.y(), 0).normalized();
  moveBy((frame.right * right * camera.width / camera.height + heading * up) * 2 * parallelScale(camera));
}

void Navigator::orbitBy(double azimuth, double elevation) {
  const Camera& camera = scene_.camera();
  if (scene_.planView()) return;
  orbitAbout(scene_.groundPoint(camera.width / 2.0, camera.height / 2.0).value_or(camera.target), azimuth,
             elevation);
}

void Navigator::orbitAbout(const Vec3& pivot, double azimuth, double elevation) {
  Camera camera = scene_.camera();
  const double pitch = pitchOf(camera);
  const double wanted =
      std::clamp(pitch + elevation, std::min(scene_.limits().flattest, pitch), kSteepest) - pitch;
  const Vec3 right = frameOf(camera).right;
  const auto turned = [&](double rise) {
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(azimuth * kRadians, Vec3::UnitZ()) * Eigen::AngleAxisd(-rise * kRadians, right))
            .toRotationMatrix();
    Camera next = camera;
    next.eye = pivot + turn * (camera.eye - pivot);
    next.target = pivot + turn * (camera.target - pivot);
    return next;
  };
  Camera next = turned(wanted);
  if (next.eye.z() < scene_.groundHeight() + scene_.limits().leastHeight && next.eye.z() < camera.eye.z())
    next = turned(0);
  scene_.setCamera(next);
}

void Navigator::moveBy(const Vec3& offset) {
  // Near the horizon a pixel is kilometres: one move never goes further than a few pictures.
  const double most = 4 * parallelScale(scene_.camera()) + 10;
  const double length = offset.norm();
  const Vec3 step = length > most ? (offset * (most / length)).eval() : offset;
  Camera camera = scene_.camera();
  camera.eye += step;
  camera.target += step;
  scene_.setCamera(camera);
}

std::optional<Vec3> Navigator::onPlane(double x, double y, double z) const {
  return meetPlane(scene_.through(x, y), z);
}

}  // namespace lodestone
