// The classes of a whole city's vertices, as its simplification sees them.
#pragma once

#include "model/component_mesh.h"
#include "model/diagnostics.h"
#include "model/progress.h"
#include "model/result.h"

namespace lodestone {

struct ClassifiedCity {
  ComponentMesh mesh;  ///< group by group of touching buildings; objects name the city's buildings
  Classification classes;
};

/// classify() of each group of touching buildings by itself, as simplifyCity() does it: what counts as
/// touching depends on the size of the model. In parallel over groups, the same for any number of threads.
/// \throw Cancelled
[[nodiscard]] Result<ClassifiedCity> classifyCity(const CityModel& city, double gap,
                                                  const Progress& progress = {});

}  // namespace lodestone
