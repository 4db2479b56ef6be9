// Which of an object's levels of detail is the finer one.
#pragma once

#include <limits>
#include <string>

namespace lodestone {

/// What a use makes of the levels that do not stand in a row with the others.
struct LodRanks {
  double unsaid;                                              ///< rank of a geometry that names no LoD
  double interior = std::numeric_limits<double>::infinity();  ///< highest rank of LoD 4, which adds rooms
};

/// "2.2" → 2.2, "lod3" → 3, "2.x" → 2: the first number in the name of a level. Linear in the length.
[[nodiscard]] double lodRank(const std::string& lod, const LodRanks& ranks);

}  // namespace lodestone
