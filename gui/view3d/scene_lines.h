// The line sets of a scene, as segments.
#pragma once

#include <optional>
#include <span>

#include "gui/view3d/overlays.h"
#include "model/city_model.h"
#include "model/cluster_tree.h"

namespace lodestone {

/// Streets, rails and water on the plane z = `ground`, all in `colour` where one is given.
[[nodiscard]] LineSegments streetLines(std::span<const LineLayer> layers, double ground,
                                       const Palette& palette, const std::optional<Rgb>& colour = {});
/// Outlines of the drawn clusters' hulls: at the top, at the bottom, and the corners between.
[[nodiscard]] LineSegments hullLines(const ClusterTree& tree, std::span<const DrawnNode> drawn,
                                     const Palette& palette);
/// The boxes that stand for the drawn clusters' negative space, as seen from `eye`.
[[nodiscard]] LineSegments negativeSpaceLines(const ClusterTree& tree, std::span<const DrawnNode> drawn,
                                              const Vec3& eye, const Palette& palette);

}  // namespace lodestone
