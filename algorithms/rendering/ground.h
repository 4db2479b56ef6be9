// The ground that a picture shows under a level: buildings know how high they stand, and that is all there
// is.
#pragma once

#include <vector>

#include "algorithms/rendering/level_mesh.h"

namespace lodestone {

/// A grid of heights over the level and some way around it, as smooth as the buildings allow and nowhere
/// above the base of a building. Flat ground has no grid, only a level, which also holds beyond the grid.
struct Ground {
  double level = 0;
  Vec2 min = Vec2::Zero();
  double cell = 1;  ///< metres
  int nodes = 0;    ///< along each side; 0: flat
  std::vector<double> heights;

  [[nodiscard]] double heightAt(const Vec2& p) const;
};

[[nodiscard]] Ground makeGround(const std::vector<ObjectStand>& stands, const Box3& box);

/// Adds the grid's triangles, and walls from the objects down to it, both painted as given.
void addGround(LevelMesh& mesh, const Ground& ground, std::uint8_t groundPaint, std::uint8_t wallPaint);

}  // namespace lodestone
