// The four classes of what the eye filters away (Du, Zhu and Zhao, section 3.2; resources/docs/methods.md,
// 5).
#pragma once

#include "model/perception.h"

namespace lodestone {

/// Gaussian maximum likelihood with priors, started from k-means and refined until stable; σ is at least 0.3
/// grey levels. The classes are cut where neighbouring Gaussians, weighted by their priors, cross between
/// their means, rounded to a bin. Cuts that the options name are taken instead: such a threshold belongs to
/// its class, found cuts that it passes give way to it, and so does an upper class that is named below a
/// lower one. The Gaussians are those of the classes as they are cut. Fewer differences than classes leave
/// the upper classes empty. Cost: O(bins²) for the start and O(bins) a round, of which there are at most some
/// hundred.
[[nodiscard]] DifferenceClasses classifyDifferences(const DifferenceHistogram& histogram,
                                                    const PerceiveOptions& options);

}  // namespace lodestone
