#include "gui/view3d/sight_fan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lodestone {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kDegreesAStep = 2;  // of the arc
constexpr double kLeastDistance = 0.1;
constexpr double kLeastAngle = 1, kMostAngle = 169;

Vec3 onGround(const SightOptions& sight, double turn, double distance) {
  const double heading = (sight.heading + turn) * kRadians;
  return sight.foot() + Vec3(std::sin(heading), std::cos(heading), 0) * distance;
}

/// Degrees from the middle of the fan to a point, −180 to 180, clockwise.
double turnOf(const SightOptions& sight, const Vec3& to) {
  SightOptions turned = sight;
  turned.turnTo(to);
  return std::remainder(turned.heading - sight.heading, 360);
}

}  // namespace

Vec3 handlePoint(const SightOptions& sight, SightHandle handle) {
  switch (handle) {
    case SightHandle::Far:
      return onGround(sight, 0, sight.distance);
    case SightHandle::Left:
      return onGround(sight, -sight.angle / 2, sight.distance / 2);
    case SightHandle::Right:
      return onGround(sight, sight.angle / 2, sight.distance / 2);
    case SightHandle::Foot:
      break;
  }
  return sight.foot();
}

SightOptions pulled(const SightOptions& sight, SightHandle handle, const Vec3& to) {
  SightOptions next = sight;
  switch (handle) {
    case SightHandle::Foot:
      next.standAt(to);
      break;
    case SightHandle::Far:
      next.turnTo(to);
      next.distance = std::max((to - sight.foot()).norm(), kLeastDistance);
      break;
    case SightHandle::Left:
    case SightHandle::Right:
      next.angle = std::clamp(2 * std::abs(turnOf(sight, to)), kLeastAngle, kMostAngle);
      break;
  }
  return next;
}

std::vector<Vec3> arcOf(const SightOptions& sight) {
  const int steps = std::max(2, static_cast<int>(std::ceil(sight.angle / kDegreesAStep)));
  std::vector<Vec3> arc;
  for (int i = 0; i <= steps; ++i)
    arc.push_back(onGround(sight, sight.angle * (static_cast<double>(i) / steps - 0.5), sight.distance));
  return arc;
}

Box3 bounds(const SightOptions& sight) {
  Box3 box;
  box.add(sight.foot());
  box.add(sight.eye());
  for (const Vec3& point : arcOf(sight)) box.add(point);
  return box;
}

}  // namespace lodestone
