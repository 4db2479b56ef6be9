// A camera that flies: key cameras and the way between them.
#pragma once

#include <vector>

#include "model/camera.h"

namespace lodestone {

struct KeyCamera {
  double time = 0;  ///< seconds from the start
  Vec3 eye = Vec3::Zero();
  Vec3 target = Vec3::UnitY();
  double fov = 45;  ///< vertical, degrees
  bool operator==(const KeyCamera&) const = default;
};

/// Between two keys each number follows the monotone cubic (Fritsch and Carlson 1980): smooth through the
/// keys, and never beyond the two that it lies between, so that a camera at 50 m does not dip into a roof.
struct FlightPath {
  std::vector<KeyCamera> keys;  ///< times rise
  bool operator==(const FlightPath&) const = default;

  /// Seconds from the first key to the last one.
  [[nodiscard]] double duration() const;
  /// `seconds` after the first key; before it or after the last one that key. \pre there is a key
  [[nodiscard]] Camera at(double seconds, int width, int height) const;
};

/// Gives keys the times at which an eye that flies straight from one to the next at `speed` metres a second
/// is there. \pre speed > 0
void timeBySpeed(FlightPath& path, double speed);

}  // namespace lodestone
