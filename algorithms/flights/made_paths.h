// Camera paths that are made for a city (resources/docs/methods.md, 1.6 and 4).
#pragma once

#include <cstdint>
#include <vector>

#include "model/flight_path.h"

namespace lodestone {

/// The path of Chang et al. 2008, section 9: it begins among buildings, at the height of their roofs, and
/// goes out and up slowly until the whole city is in view from above. The paper gives no numbers: ours stands
/// at the densest place, looks at the middle of the city, and climbs so that each second it is a fixed share
/// higher. `boxes` are the buildings'. \pre some box is not empty
[[nodiscard]] FlightPath groundToSky(const std::vector<Box3>& boxes, double seconds = 60);

/// The paths of Polys et al. 2016, section 5: random waypoints in plan within `area`, a fixed height above
/// its ground (in an area of at least that size), straight ahead, at a fixed speed, for about so many
/// seconds.
struct RandomFlight {
  double height = 50;  ///< metres above the lowest ground
  double speed = 20;   ///< metres a second
  double seconds = 70;
  double fov = 45;  ///< vertical, degrees
  std::uint32_t seed = 1;
};
[[nodiscard]] FlightPath randomPath(const Box3& area, const RandomFlight& flight);

}  // namespace lodestone
