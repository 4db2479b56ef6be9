// A simplification with what it did to the contacts, and the search for a (resources/docs/methods.md, 2.4 and
// 2.6).
#pragma once

#include <span>

#include "algorithms/simplification/simplification.h"
#include "model/perception.h"
#include "model/simplify_report.h"

namespace lodestone {

struct Measured {
  Simplified simplified;
  Admission admission;                  ///< that it was made with; everything without a perception
  std::vector<ContactReport> contacts;  ///< in the order of Classification::contacts
  double hausdorff = 0;                 ///< metres, the greater of both ways
  double a = 0;                         ///< that was used
  std::vector<AutoTrial> trials;        ///< of the search for a; empty where it was given
};

/// The index of the trial that `auto` takes: of those whose score is within a twentieth of the least, the one
/// with the fewest separated and lost contacts; of equal ones that with the smaller score, then the smaller
/// a. \pre not empty
[[nodiscard]] std::size_t bestTrial(std::span<const AutoTrial> trials);

/// simplify(), or simplifySettled() where there is a perception, and its measures. With `options.aAuto` and
/// method Topology or Combined: the best of fixed values of a from 1 to 8, by bestTrial(). The values are
/// tried in parallel. \throw Cancelled
[[nodiscard]] Measured simplifyAndMeasure(const ComponentMesh& mesh, const Classification& classes,
                                          const SimplifyOptions& options, const Progress& progress = {},
                                          const Perception* perception = nullptr);

/// The measures of what a method has already made, with `a`. \throw Cancelled
[[nodiscard]] Measured measureSimplified(const ComponentMesh& mesh, const Classification& classes,
                                         Simplified simplified, double a, const Progress& progress = {});

/// All figures of one model.
[[nodiscard]] SimplifyReport reportOf(const ComponentMesh& mesh, const Classification& classes,
                                      const Measured& measured);

}  // namespace lodestone
