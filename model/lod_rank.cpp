#include "model/lod_rank.h"

#include <algorithm>

#include "model/attributes.h"

namespace lodestone {

double lodRank(const std::string& lod, const LodRanks& ranks) {
  const std::size_t digit = lod.find_first_of("0123456789");
  if (digit == std::string::npos) return ranks.unsaid;
  const double rank = parseNumber(lod.substr(digit)).value_or(lod[digit] - '0');
  constexpr double kRooms = 4;
  return rank >= kRooms ? std::min(rank, ranks.interior) : rank;
}

}  // namespace lodestone
