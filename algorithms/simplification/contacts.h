// Which components still touch (resources/docs/methods.md, 2.4).
#pragma once

#include "algorithms/simplification/simplification.h"
#include "model/simplify_report.h"

namespace lodestone {

/// The fate of each contact of the original. Two components still touch when their surfaces are no farther
/// apart than they were, within the noise of the coordinates (1e-6 of the model's diagonal), or when one lies
/// inside the other's closed surface. In parallel. \throw Cancelled
[[nodiscard]] std::vector<ContactReport> followContacts(const ComponentMesh& original,
                                                        const Classification& classes,
                                                        const Simplified& simplified,
                                                        const Progress& progress = {});

}  // namespace lodestone
