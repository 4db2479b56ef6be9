// Cameras around a model.
#pragma once

#include <vector>

#include "model/camera.h"
#include "model/perceive_options.h"

namespace lodestone {

/// Square pictures that show the whole box, from directions spread evenly over the sphere, over its upper
/// half, or around the box at eye height (1.7 m above its base, from two widths away or so far that all of it
/// is in the picture). `turn` (0–1) gives other viewpoints of the same kind: those to measure with are not
/// those that were classified. None for an empty box.
[[nodiscard]] std::vector<Camera> viewpointsAround(const Box3& box, const PerceiveOptions& options,
                                                   double turn = 0);

/// Eyes at many more places of the same kind, in between: for what no picture shows.
[[nodiscard]] std::vector<Vec3> closerViewpoints(const Box3& box, const PerceiveOptions& options);

}  // namespace lodestone
