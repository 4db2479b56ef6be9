// A simplification that keeps hidden what is hidden, and together what touches (resources/docs/methods.md,
// 5.4).
#pragma once

#include "algorithms/simplification/simplification.h"
#include "model/perception.h"

namespace lodestone {

struct Settled {
  Simplified simplified;
  Admission admission;  ///< that it was made with
};

/// simplify() where admissionOf() allows it, but for what does harm. It is tried: what does is taken back
/// from what is admitted, again and again until nothing does.
///
/// - With `options.unseen` the unseen triangles that come into sight of closerViewpoints(): a hidden back of
/// a
///   wall that is drawn to its corners may stand out through another wall.
/// - With Combined the triangles at contacts that come apart, and if that was not enough all of both
///   components; not at contacts of a component that nobody sees.
///
/// After `mostRounds` all that is in question is taken back at once, so that both always hold. The same for
/// any number of threads. Cost: a simplification and, for each hidden triangle that is left, some hundred
/// rays, a round; one round for each of most models, six at most of those tried. \throw Cancelled;
/// std::runtime_error when Embree cannot build the scene
[[nodiscard]] Settled simplifySettled(const ComponentMesh& mesh, const Classification& classes,
                                      const Perception& perception, const SimplifyOptions& options,
                                      const Progress& progress = {}, int mostRounds = 8);

}  // namespace lodestone
