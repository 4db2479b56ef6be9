// How heavy a model is: the one way in which polygons and triangles of what is drawn are counted, in every
// figure, file, table and panel.
#pragma once

#include <cstdint>

#include "model/geometry.h"

namespace lodestone {

struct Geometry;

/// Polygons are counted as the legible paper counts them (Chang et al. 2008; resources/docs/methods.md,
/// Polygons): an upright face of four corners without holes, a wall quad, is one; of any other face each
/// triangle is one; the ground is none, since nobody sees it. Shapes decide and not labels, so that a block
/// counts the same with semantic surfaces and without.
struct FaceCount {
  std::uint64_t polygons = 0;
  std::uint64_t triangles = 0;  ///< of all faces as they are written, the ground included

  FaceCount& operator+=(const FaceCount& other) {
    polygons += other.polygons;
    triangles += other.triangles;
    return *this;
  }
  bool operator==(const FaceCount&) const = default;
};

/// What is drawn as a part of all: polygons by polygons; 1 where there are none.
[[nodiscard]] double share(const FaceCount& drawn, const FaceCount& all);

/// Faces of a geometry; those of rooms (interior walls, floors, ceilings) are none. The ground is what is
/// labelled so; where nothing is labelled, the level faces at the lowest height, within a centimetre, of a
/// geometry that is higher. Upright is what leans by less than about a degree. Cost: linear.
[[nodiscard]] FaceCount facesOf(const Geometry& geometry);

/// Faces of the block over a footprint (algorithms/geometry/meshing.h, makeBlock()): 2V − 2 polygons and 4V −
/// 4 triangles for V ground vertices without holes; 2 polygons and 4 triangles more for each hole.
[[nodiscard]] FaceCount facesOfBlock(const MultiPolygon& footprint);

}  // namespace lodestone
