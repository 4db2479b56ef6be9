// The shape of a viewpoint on the ground: a fan from the feet of who stands there, and places to drag it by.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/sight_options.h"

namespace lodestone {

/// What is dragged: the whole viewpoint; direction and distance; one side of the opening.
enum class SightHandle { Foot, Far, Left, Right };
inline constexpr std::array<SightHandle, 4> kSightHandles{SightHandle::Foot, SightHandle::Far,
                                                          SightHandle::Left, SightHandle::Right};

/// On the ground's plane; the sides stand half way.
[[nodiscard]] Vec3 handlePoint(const SightOptions& sight, SightHandle handle);
/// What a drag of the handle to a point of the ground's plane makes of the viewpoint.
[[nodiscard]] SightOptions pulled(const SightOptions& sight, SightHandle handle, const Vec3& to);
/// Points of the arc at the fan's far end, from left to right.
[[nodiscard]] std::vector<Vec3> arcOf(const SightOptions& sight);
/// Around the fan and the eye.
[[nodiscard]] Box3 bounds(const SightOptions& sight);

}  // namespace lodestone
