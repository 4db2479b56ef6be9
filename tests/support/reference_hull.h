// The merged hull as methods.md 1.3 tells it, word by word, in exact arithmetic and without any cleverness:
// O(n³) and worse.
#pragma once

#include <string>
#include <vector>

#include "model/geometry.h"

namespace lodestone::test {

/// \pre children are simple and counter-clockwise.
[[nodiscard]] Ring referenceHull(const std::vector<Ring>& children, std::size_t targetEdges);

/// What is always true of a merged hull; empty, or what is broken.
[[nodiscard]] std::string brokenRule(const Ring& hull, const std::vector<Ring>& children,
                                     std::size_t targetEdges);

}  // namespace lodestone::test
