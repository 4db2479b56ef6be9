// What may be simplified so that what is hidden stays hidden, and what touches goes on touching
// (resources/docs/methods.md, 5.4).
#pragma once

#include "algorithms/simplification/admission.h"
#include "model/progress.h"

namespace lodestone {

/// admissionOf(), without what has to be left alone. It is tried: what does harm is taken back from what is
/// admitted, again and again until nothing does, at most eight times.
///
/// - With `options.unseen` the unseen triangles that come into sight of closerViewpoints(): a hidden back of
/// a
///   wall that is drawn to its corners may stand out through another wall.
/// - With Combined the triangles at contacts that come apart, and if that was not enough all of both
///   components; not at contacts of a component that nobody sees.
///
/// The same for any number of threads. Cost: a simplification and, for each hidden triangle that is left,
/// some hundred rays, a round; with neither of both nothing. \throw Cancelled; std::runtime_error when Embree
/// cannot build the scene
[[nodiscard]] Admission settledAdmission(const ComponentMesh& mesh, const Classification& classes,
                                         const Perception& perception, const SimplifyOptions& options,
                                         const Progress& progress = {});

}  // namespace lodestone
