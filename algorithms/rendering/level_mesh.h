// A whole level as one soup of triangles, for ray casting.
#pragma once

#include "algorithms/rendering/ray_scene.h"
#include "model/lod_chain.h"
#include "model/progress.h"

namespace lodestone {

/// Where an object of a level stands, for the ground under it.
struct ObjectStand {
  Ring outline;  ///< outer ring of the (first) footprint
  double base = 0;
};

struct LevelMesh {
  Vec3 origin = Vec3::Zero();  ///< of the soup's coordinates, in the level's: the middle of its box
  Box3 box;                    ///< of all geometry, in the level's coordinates
  TriangleSoup soup;           ///< in object order, ground surfaces left out: nothing sees them from above
  std::vector<std::uint8_t> paint;            ///< of each triangle: an index into `colours`
  std::vector<std::array<float, 3>> colours;  ///< sRGB
  std::vector<std::uint32_t> object;          ///< of each triangle
  std::vector<ObjectStand> stands;            ///< of each object
};

/// The triangles of all objects of a level. In parallel, the same for any number of threads. \throw Cancelled
[[nodiscard]] LevelMesh levelMesh(const LodLevel& level, const Progress& progress = {});

}  // namespace lodestone
