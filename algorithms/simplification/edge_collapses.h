// Edge collapses in the order of their cost (Garland and Heckbert 1997; Wang et al. 2021, section 3.3).
#pragma once

#include "algorithms/simplification/simplification.h"

namespace lodestone {

/// Collapses until the share `rate` of the triangles is removed; the last operation may overshoot.
/// `options.method`: Topology and Qem move vertices onto their neighbours (half-edge collapses), QemOptimal
/// moves both ends of an edge to where their quadrics are least. A collapse must keep the surface a manifold
/// and turn no triangle over; one that changes the look of the surface costs by its length, but QemOptimal
/// takes no notice of textures and materials. A component in which no collapse is legal is removed whole when
/// its turn comes, at cost area · diagonal²; not the last one that is left, unless the rate is 1: then fewer
/// triangles go than were asked for.
///
/// Combined moves vertices as Topology does, Perception contracts edges by what they cost to the eye
/// (component_contractions.h); both where `admission` lets them: a triangle that is not admitted stays to the
/// last bit. What nobody sees goes first, whole components as far as the rate has room for them, the smallest
/// first; no other component goes. In parallel over components, the same for any number of threads. Cost: O(n
/// log n). \throw Cancelled
[[nodiscard]] Simplified simplifyByCollapses(const ComponentMesh& mesh, const Classification& classes,
                                             const SimplifyOptions& options, const Progress& progress = {},
                                             const Admission& admission = {});

}  // namespace lodestone
