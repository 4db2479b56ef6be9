// How an edge of one component meets a triangle of another (Wang et al. 2021, section 3.2.2).
#pragma once

#include <cstdint>

#include "algorithms/geometry/triangle_distance.h"

namespace lodestone {

/// What an edge p1 → p2, lengthened at each end by a share of its length, has in common with a triangle.
struct EdgeContact {
  bool meets = false;  ///< anything at all
  bool crosses =
      false;  ///< the edge itself passes from one side of the plane to the other within the triangle
  bool entersAt1 = false;  ///< of a crossing: the normal says that p1 is the inner end (acute angle)
  bool touches1 = false;   ///< p1 lies on the closed triangle
  bool touches2 = false;
  bool overlaps = false;  ///< coplanar, and the edge runs over the triangle with no end on it
  bool reaches1 = false;  ///< met only in the part by which p1's end was lengthened
  bool reaches2 = false;
};

/// `tolerance` (metres) is how far from a plane a point still lies in it: the noise of the coordinates.
/// Triangles without area meet nothing. Differs from the paper, which calls parallel "no intersection": most
/// contacts of real buildings are walls that stand on slabs.
[[nodiscard]] EdgeContact edgeContact(const Vec3& p1, const Vec3& p2, const TriangleCorners& triangle,
                                      double gap, double tolerance);

}  // namespace lodestone
