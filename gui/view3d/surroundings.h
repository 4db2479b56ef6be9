// The buildings around the one on the stage: what is seen, or not, past it. Made on any thread, shared
// without locks.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gui/view3d/city_mesh.h"
#include "gui/view3d/palette.h"

namespace lodestone {

/// What a visibility analysis says of a target past one model: of the original it is Seen or Unseen.
enum class TargetFate : std::uint8_t {
  Unseen,
  Seen,
  Appeared,  ///< seen, but not past the original
  Vanished   ///< not seen, but past the original
};
[[nodiscard]] const Rgb& targetColour(TargetFate fate, const Palette& palette);

struct Surroundings {
  std::vector<std::uint32_t> buildings;  ///< of the city, ascending: the targets
  NodeMesh mesh;                         ///< node `mesh.firstNode` + i is buildings[i]
  std::vector<NodeId> nodes;             ///< those that have anything to draw
  Box3 bounds;                           ///< local metres
};

/// A ball.
struct Reach {
  Vec3 centre = Vec3::Zero();
  double radius = 0;  ///< metres
};

/// Buildings that reach into any of the balls, but for `without` (ascending). Cost: linear in the city's
/// vertices.
[[nodiscard]] std::vector<std::uint32_t> buildingsWithin(const CityModel& city,
                                                         std::span<const Reach> reaches,
                                                         std::span<const std::uint32_t> without);
/// Nodes are numbered from `firstNode`. In parallel, the same for any number of threads.
[[nodiscard]] std::shared_ptr<const Surroundings> makeSurroundings(const CityModel& city,
                                                                   std::vector<std::uint32_t> buildings,
                                                                   NodeId firstNode, const Vec3& anchor);
/// The box of one target; empty where nothing of it is drawn.
[[nodiscard]] Box3 boxOf(const Surroundings& around, std::size_t target);

}  // namespace lodestone
