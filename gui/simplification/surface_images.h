// The textures of a building, read for the screen.
#pragma once

#include <memory>

#include "gui/view3d/surface_overlay.h"
#include "model/city_model.h"
#include "model/progress.h"

namespace lodestone {

/// Images that the triangles of `mesh` show, no larger than 2048 pixels a side, and the colours of all
/// materials. An image that cannot be read is left out. \throw Cancelled
[[nodiscard]] std::shared_ptr<const SurfaceLook> readSurfaceLook(const CityModel& city,
                                                                 const ComponentMesh& mesh,
                                                                 const Progress& progress);

/// Whether there is anything to see: an image, or materials that may differ.
[[nodiscard]] bool hasOwnLook(const SurfaceLook& look);

}  // namespace lodestone
