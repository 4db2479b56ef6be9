// Which buildings are seen from a viewpoint (Wang et al. 2021, section 4.3; resources/docs/methods.md, 2.5).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "algorithms/rendering/rendering.h"
#include "model/city_model.h"
#include "model/component_mesh.h"
#include "model/progress.h"

namespace lodestone {

/// Where somebody stands, looks to, and how far sight goes. Metres in the frame of what is looked at.
struct Viewpoint {
  Vec3 eye = Vec3::Zero();
  Vec3 direction = Vec3::UnitY();
  double angle = 60;       ///< horizontal opening, degrees, above 0 and below 170
  double distance = 1000;  ///< metres
  int width = 1024;        ///< pixels
  int height = 512;
};

/// What is seen in no pixel's place.
inline constexpr std::uint32_t kNobody = 0xFFFFFFFFU;   ///< nothing within the distance
inline constexpr std::uint32_t kBlocked = 0xFFFFFFFEU;  ///< something that is no target

/// Triangles, each of one owner: a target's index, or kBlocked.
struct OwnedTriangles {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> owner;
};
/// Adds the triangles of a city's buildings as they are drawn (drawnObjects()). `ownerOf` is asked for each
/// building's owner. Coordinates are taken as they stand.
void addBuildings(const CityModel& city, const std::function<std::uint32_t(std::uint32_t)>& ownerOf,
                  OwnedTriangles& scene);
/// The same for some of the buildings.
void addBuildings(const CityModel& city, std::span<const std::uint32_t> buildings,
                  const std::function<std::uint32_t(std::uint32_t)>& ownerOf, OwnedTriangles& scene);
/// Adds a model of triangles that all are of one owner.
void addMesh(const ComponentMesh& mesh, std::uint32_t owner, OwnedTriangles& scene);

struct Sighting {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> who;     ///< the identity picture, rows from the top: an owner, or kNobody
  std::vector<std::uint32_t> pixels;  ///< of each target; it is visible where there are any
  [[nodiscard]] bool sees(std::uint32_t target) const { return pixels[target] > 0; }
};

/// One ray through the middle of each pixel; of surfaces that lie in one place (1e-5 of the distance) the one
/// added last is seen. The same pixels for any number of threads. Cost: O(pixels · log triangles).
/// \throw Cancelled
[[nodiscard]] Sighting lookFrom(const Viewpoint& viewpoint, const OwnedTriangles& scene,
                                std::uint32_t targets, const Progress& progress = {});

/// Targets that are visible in one sighting and not in the other, ascending. \pre both have the same targets.
[[nodiscard]] std::vector<std::uint32_t> seenOnlyIn(const Sighting& one, const Sighting& other);

/// Each target in a colour of its own, those that differ from `original` in red, what is no target in grey.
/// White: nobody.
[[nodiscard]] Picture identityPicture(const Sighting& sighting, const Sighting& original);

/// Rate of simplification at a share of the viewing distance: 0–30% in the nearest third, 30–70% in the
/// middle, 70–95% in the farthest, rising evenly in each (the street of figure 18); 95% beyond.
[[nodiscard]] double streetRate(double share);

}  // namespace lodestone
