// What may be simplified so that what is hidden stays hidden (resources/docs/methods.md, 5.4).
#pragma once

#include "algorithms/simplification/admission.h"
#include "model/progress.h"

namespace lodestone {

/// admissionOf(), without those unseen triangles that would come into sight if they were simplified. A hidden
/// back of a wall that is drawn to its corners may stand out through another wall. So it is tried: what comes
/// into sight of closerViewpoints() is taken back from what is admitted, again and again until nothing does,
/// at most eight times. The same for any number of threads. Cost: a simplification and some hundred rays for
/// each hidden triangle that is left, a round; without `options.unseen` none. \throw Cancelled;
/// std::runtime_error when Embree cannot build the scene
[[nodiscard]] Admission settledAdmission(const ComponentMesh& mesh, const Classification& classes,
                                         const Perception& perception, const SimplifyOptions& options,
                                         const Progress& progress = {});

}  // namespace lodestone
