// Simplification of every building of a city (resources/docs/methods.md, section 2).
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "algorithms/simplification/touching_buildings.h"
#include "model/city_model.h"
#include "model/component_mesh.h"
#include "model/perceive_options.h"
#include "model/progress.h"
#include "model/result.h"
#include "model/simplify_options.h"
#include "model/simplify_report.h"

namespace lodestone {

/// A city of some buildings alone, their exterior geometries replaced by `mesh`: what is left of
/// makeComponentMesh(city, buildings). Materials, textures and coordinates are those of `city`.
[[nodiscard]] CityModel simplifiedBuildings(const CityModel& city,
                                            const std::vector<std::uint32_t>& buildings,
                                            const ComponentMesh& mesh);

struct SimplifiedCity {
  std::shared_ptr<const CityModel> city;  ///< the buildings' geometries replaced, everything else as it was
  SimplifyReport report;                  ///< of all groups together; contacts name components group by group
  std::size_t groups = 0;
  std::size_t buildingsGone = 0;  ///< left out: nothing was left of them
};

/// The rate of a group of touching buildings, given as indices into the city's. Called from several threads.
using GroupRate = std::function<double(const std::vector<std::uint32_t>& group)>;

/// Called with all groups once they are known, before work on any of them begins, from the caller's thread.
using GroupsKnown = std::function<void(const std::vector<std::vector<std::uint32_t>>& groups)>;

/// Each group of touching buildings as one model, so that row houses do not gape: `rate` of the triangles of
/// each, or what `rateOf` says. Methods that need pictures look at each group by itself, as `perceive` says;
/// a group in which nothing may be touched is told of (Code::NothingAdmitted). The finest exterior geometry
/// of each source object is replaced by what is left of it, triangles with the semantics, materials and
/// textures of those they come from; other geometries of the buildings are left out. In parallel over groups,
/// the same for any number of threads. \throw Cancelled
[[nodiscard]] Result<SimplifiedCity> simplifyCity(std::shared_ptr<const CityModel> city,
                                                  const SimplifyOptions& options,
                                                  const Progress& progress = {}, const GroupRate& rateOf = {},
                                                  const PerceiveOptions& perceive = {},
                                                  const GroupsKnown& groupsKnown = {});

}  // namespace lodestone
