// The viewpoint of the workbench's visibility analysis (Wang et al. 2021, section 4.3;
// resources/docs/methods.md, 2.5).
#pragma once

#include "model/geometry.h"
#include "model/options.h"

namespace lodestone {

/// Where somebody stands, looks to, and how far sight goes. Metres in the city's local frame, degrees.
struct SightOptions {
  bool placed = false;  ///< else there is no viewpoint yet
  double x = 0;         ///< the ground under the viewpoint
  double y = 0;
  double z = 0;
  double height = 1.7;    ///< of the eye above that ground: a person's
  double heading = 0;     ///< clockwise from north
  double tilt = 0;        ///< above the horizon
  double angle = 60;      ///< horizontal opening
  double distance = 300;  ///< from the eye
  bool operator==(const SightOptions&) const = default;

  [[nodiscard]] Vec3 foot() const { return {x, y, z}; }
  [[nodiscard]] Vec3 eye() const { return {x, y, z + height}; }
  /// Unit.
  [[nodiscard]] Vec3 direction() const;
  void standAt(const Vec3& foot);
  /// Sets heading and tilt. \pre the direction is not zero.
  void lookAlong(const Vec3& direction);
  /// Sets the heading alone; nothing where the point is straight above or below.
  void turnTo(const Vec3& point);
};

template <>
const std::vector<Field<SightOptions>>& fields<SightOptions>();

}  // namespace lodestone
