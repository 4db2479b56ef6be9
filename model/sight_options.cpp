#include "model/sight_options.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lodestone {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
/// Straight up and down have no heading, and a picture no upper side.
constexpr double kSteepest = 89;

double headingOf(const Vec3& direction) {
  const double degrees = std::atan2(direction.x(), direction.y()) / kRadians;
  return degrees < 0 ? degrees + 360 : degrees;
}

}  // namespace

Vec3 SightOptions::direction() const {
  const double flat = std::cos(tilt * kRadians);
  return {flat * std::sin(heading * kRadians), flat * std::cos(heading * kRadians),
          std::sin(tilt * kRadians)};
}

void SightOptions::standAt(const Vec3& foot) {
  placed = true;
  x = foot.x();
  y = foot.y();
  z = foot.z();
}

void SightOptions::lookAlong(const Vec3& direction) {
  heading = headingOf(direction);
  const double rise = std::clamp(direction.z() / direction.norm(), -1.0, 1.0);
  tilt = std::clamp(std::asin(rise) / kRadians, -kSteepest, kSteepest);
}

void SightOptions::turnTo(const Vec3& point) {
  const Vec3 towards = point - foot();
  if (towards.x() != 0 || towards.y() != 0) heading = headingOf(towards);
}

template <>
const std::vector<Field<SightOptions>>& fields<SightOptions>() {
  using O = SightOptions;
  constexpr double kFarthest = 1e9;  // of any place from the origin
  static const std::vector<Field<O>> table{
      flag(&O::placed, "placed", "Placed", "Whether there is a viewpoint."),
      real(&O::x, "x", "East", "m", -kFarthest, kFarthest, "Of the ground under the viewpoint."),
      real(&O::y, "y", "North", "m", -kFarthest, kFarthest, "Of the ground under the viewpoint."),
      real(&O::z, "z", "Up", "m", -kFarthest, kFarthest, "Of the ground under the viewpoint."),
      real(&O::height, "height", "Height", "m", 0, 1e5,
           "Of the eye above the ground that was clicked; 1.7 m is a person's."),
      real(&O::heading, "heading", "Direction", "°", 0, 360, "Where sight goes, clockwise from north."),
      real(&O::tilt, "tilt", "Tilt", "°", -kSteepest, kSteepest,
           "How far above the horizon the middle of sight is; negative: below."),
      real(&O::angle, "angle", "Opening", "°", 0.1, 169, "Horizontal opening of sight."),
      real(&O::distance, "distance", "Distance", "m", 0.01, 1e7,
           "How far sight goes; what stands farther off is not seen."),
  };
  return table;
}

}  // namespace lodestone
