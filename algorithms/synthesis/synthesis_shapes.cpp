#include "algorithms/synthesis/synthesis_shapes.h"

#include <algorithm>

namespace lodestone {
namespace {

// Widths of `count` parts, each at least one step and none under a third of an equal share where there is
// room.
std::vector<int> splitWidth(int width, int count, SynthRandom& random) {
  std::vector<int> parts(static_cast<std::size_t>(count), width / count);
  parts.back() += width % count;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const int play = std::min(parts[i], parts[i + 1]) / 3;
    const int shift = random.between(-play, play);
    parts[i] += shift;
    parts[i + 1] -= shift;
  }
  return parts;
}

}  // namespace

int mostSteps(int width) {
  return std::max(0, width - 1);
}

Ring steppedOutline(const Lattice& lattice, const Frontage& lot, int depth, int jogs, SynthRandom& random) {
  const std::vector<int> widths = splitWidth(lot.width, jogs + 1, random);
  Ring ring{lattice.world(lot.a, lot.front), lattice.world(lot.a + lot.width, lot.front)};
  const bool deepFirst = random.chance(50);
  std::int64_t a = lot.a + lot.width;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    // Full depth and a lesser one in turn: neighbours always differ, so that every jog has two vertices.
    const bool deep = (i % 2 == 0) == deepFirst || jogs == 0;
    const int here =
        deep ? depth : random.between(depth - depth / 2, std::max(depth - depth / 2, depth - 1 - depth / 8));
    const std::int64_t b = lot.front + static_cast<std::int64_t>(lot.away) * here;
    ring.push_back(lattice.world(a, b));
    a -= widths[i];
    ring.push_back(lattice.world(a, b));
  }
  if (lot.away < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

Ring rectangle(const Lattice& lattice, const LatticeRect& r) {
  return {lattice.world(r.a0, r.b0), lattice.world(r.a1, r.b0), lattice.world(r.a1, r.b1),
          lattice.world(r.a0, r.b1)};
}

}  // namespace lodestone
