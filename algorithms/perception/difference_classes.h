// The four classes of what the eye filters away (Du, Zhu and Zhao, section 3.2; resources/docs/methods.md,
// 5).
#pragma once

#include "model/perception.h"

namespace lodestone {

/// Gaussian maximum likelihood with priors, started from k-means and refined until stable; σ is at least 0.3
/// grey levels. The classes are cut where neighbouring Gaussians, weighted by their priors, cross between
/// their means, rounded to a bin. Cuts that the options name are taken instead. Fewer differences than
/// classes leave the upper classes empty. Cost: O(bins) a round, at most some hundred rounds.
[[nodiscard]] DifferenceClasses classifyDifferences(const DifferenceHistogram& histogram,
                                                    const PerceiveOptions& options);

}  // namespace lodestone
