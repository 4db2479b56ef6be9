// Flags of perception analysis, and what there is to say about them before it begins.
#pragma once

#include <string>
#include <vector>

#include "cli/flags.h"
#include "cli/run.h"
#include "model/camera.h"
#include "model/perceive_options.h"

namespace lodestone::cli {

/// Those of the field table. Pictures are square: --size takes 1024x1024 for 1024.
void addPerceiveFlags(CLI::App& app, PerceiveOptions& options);

/// The names of a field table as flags.
template <class O>
std::vector<std::string> flagsOf() {
  std::vector<std::string> names;
  for (const Field<O>& field : fields<O>()) names.push_back("--" + field.name);
  return names;
}

/// \throw Failure (505) when one of the flags was given; `why` ends a sentence that begins with its name
void refuseGiven(const CLI::App& command, const std::vector<std::string>& flags, const std::string& why);

/// \throw Failure (503) when thresholds that are given do not rise
void requireRisingThresholds(const PerceiveOptions& options);

/// What looking takes: said before it begins, where it is much.
struct LookingCost {
  double pixels = 0;  ///< of all pictures
  double bytes = 0;   ///< at a time
  double seconds = 0;
};
/// Of `models` of so many triangles or fewer that `threads` look at, side by side; `kept`: the differences of
/// all pictures are kept to the end.
[[nodiscard]] LookingCost lookingCost(const std::vector<Camera>& cameras, std::size_t triangles, int threads,
                                      bool kept, std::size_t models = 1);
void tellCost(Run& run, const LookingCost& cost, const std::string& what);

}  // namespace lodestone::cli
