#include "algorithms/synthesis/synthesis_blocks.h"

#include <algorithm>

#include <fmt/format.h>

namespace lodestone {
namespace {

// Heights are whole eighths of a metre, as the plan is.
double storeys(int count, SynthRandom& random) {
  return count * 3.0 + random.between(0, 16) / 8.0;
}

}  // namespace

void BlockFiller::fill(BlockKind kind, const Lattice& lattice, const LatticeRect& block, const Box2& limits,
                       SynthRandom& random) {
  limits_ = limits;
  switch (kind) {
    case BlockKind::Rows:
      return fillRows(lattice, block, random);
    case BlockKind::Detached:
      return fillDetached(lattice, block, random);
    case BlockKind::Courtyards:
      return fillCourtyards(lattice, block, random);
    case BlockKind::Towers:
      return fillTowers(lattice, block, random);
    case BlockKind::Halls:
      return fillHalls(lattice, block, random);
  }
}

void BlockFiller::fillRows(const Lattice& lattice, const LatticeRect& block, SynthRandom& random) {
  fillRow(lattice, block, 1, random);
  fillRow(lattice, block, -1, random);
}

// Touching houses along one street, with a passage after every few of them.
void BlockFiller::fillRow(const Lattice& lattice, const LatticeRect& block, int away, SynthRandom& random) {
  const int deepest = block.depth() / 2 - lattice.steps(2);
  const int depth = std::min(lattice.between(random, 9, 13), deepest);
  const std::int64_t front = away > 0 ? block.b0 : block.b1;
  const int floors = random.between(2, 5);
  const int year = random.between(1880, 1990);
  std::int64_t a = block.a0;
  while (true) {
    for (int house = random.between(4, 9); house > 0; --house) {
      const int width = lattice.between(random, 6, 10);
      if (a + width > block.a1 || full()) return;
      const int own = floors + random.between(-1, 1);
      const Look look{storeys(std::max(1, own), random), random.chance(20) ? "mixed" : "residential",
                      year + random.between(0, 30)};
      addStepped(lattice, {a, front, away, width}, depth, look, random);
      a += width;
    }
    a += lattice.between(random, 3, 6);
  }
}

void BlockFiller::fillDetached(const Lattice& lattice, const LatticeRect& block, SynthRandom& random) {
  for (const int away : {1, -1}) {
    std::int64_t a = block.a0;
    while (!full()) {
      const int lot = lattice.between(random, 15, 24);
      if (a + lot > block.a1) break;
      const int width = lattice.between(random, 8, 12);
      const int setback = lattice.between(random, 2, 5);
      const int room = block.depth() / 2 - setback - lattice.steps(2);
      const int depth = std::min(lattice.between(random, 8, 12), room);
      const std::int64_t front = away > 0 ? block.b0 + setback : block.b1 - setback;
      const std::int64_t left = a + random.between(0, lot - width - lattice.steps(1));
      const Look look{storeys(random.between(1, 3), random), "residential", random.between(1920, 2020)};
      addStepped(lattice, {left, front, away, width}, depth, look, random);
      a += lot;
    }
  }
}

// Closed perimeter buildings around a yard while holes are left to give, rows after that.
void BlockFiller::fillCourtyards(const Lattice& lattice, const LatticeRect& block, SynthRandom& random) {
  LatticeRect outer = block;
  const bool enough = left_.steps < 0 || left_.steps >= 2;
  if (left_.holes > 0 && enough) {
    const int wing = lattice.between(random, 9, 12);
    outer.a1 = block.a0 + std::min(block.width(), lattice.between(random, 36, 56));
    const LatticeRect yard{outer.a0 + wing, outer.b0 + wing, outer.a1 - wing, outer.b1 - wing};
    Polygon polygon{rectangle(lattice, outer), {rectangle(lattice, yard)}};
    std::reverse(polygon.holes[0].begin(), polygon.holes[0].end());
    addPolygon(std::move(polygon),
               {storeys(random.between(4, 6), random), "mixed", random.between(1870, 1935)});
    outer.a0 = outer.a1;  // the first row house shares the yard building's wall
    outer.a1 = block.a1;
  }
  fillRows(lattice, outer, random);
}

void BlockFiller::fillTowers(const Lattice& lattice, const LatticeRect& block, SynthRandom& random) {
  std::int64_t a = block.a0;
  while (!full()) {
    const int lot = lattice.between(random, 30, 52);
    if (a + lot > block.a1) break;
    const int width = lattice.between(random, 18, 28);
    const int depth = std::min(lattice.between(random, 18, 30), block.depth() - lattice.steps(4));
    const int slack = block.depth() - depth;
    const Frontage place{a + (lot - width) / 2, block.b0 + slack / 2, 1, width};
    const bool tall = random.chance(35);
    const int floors = tall ? random.between(20, 55) : random.between(6, 16);
    addStepped(lattice, place, depth, {storeys(floors, random), "office", random.between(1960, 2022)},
               random);
    a += lot;
  }
}

void BlockFiller::fillHalls(const Lattice& lattice, const LatticeRect& block, SynthRandom& random) {
  std::int64_t a = block.a0;
  while (!full()) {
    const int width = lattice.between(random, 26, 60);
    if (a + width > block.a1) break;
    const int depth = std::min(lattice.between(random, 18, 40), block.depth() - lattice.steps(4));
    const int gap = lattice.between(random, 6, 14);
    const Look look{storeys(random.between(2, 4), random), random.chance(60) ? "industrial" : "commercial",
                    random.between(1955, 2020)};
    addStepped(lattice, {a, block.b0 + lattice.steps(2), 1, width}, depth, look, random);
    a += width + gap;
  }
}

void BlockFiller::addStepped(const Lattice& lattice, const Frontage& lot, int depth, const Look& look,
                             SynthRandom& random) {
  if (full()) return;
  const int jogs = drawJogs(mostSteps(lot.width), random);
  addPolygon({steppedOutline(lattice, lot, depth, jogs, random), {}}, look);
}

// Jogs of the next outline. With a budget the mean of what is left is drawn, spread over 0 to 2 means, and
// without spread for the last buildings: so the very last one takes exactly what remains.
int BlockFiller::drawJogs(int most, SynthRandom& random) const {
  if (left_.steps < 0) {
    const int roll = random.between(0, 99);
    return std::min(most, roll < 50 ? 0 : roll < 78 ? 1 : roll < 95 ? 2 : 3);
  }
  constexpr int kSpreads = 5;
  constexpr double kSpread[kSpreads] = {0, 0.5, 1, 1.5, 2};
  constexpr std::int64_t kCalmEnd = 256;
  const auto free = static_cast<double>(left_.steps - 2 * left_.holes);
  const double mean = free / static_cast<double>(left_.buildings);
  const double wanted = left_.buildings <= kCalmEnd ? mean : mean * kSpread[random.between(0, kSpreads - 1)];
  return std::clamp(static_cast<int>(wanted + random.unit()), 0, most);
}

void BlockFiller::addPolygon(Polygon polygon, const Look& look) {
  const Box2 box = bounds(polygon.outer);
  if (!limits_.contains(box.min) || !limits_.contains(box.max)) return;
  Building building;
  building.object.type = ObjectType::Building;
  building.object.id = fmt::format("B{:07}", model_.buildings.size());
  building.height = look.height;
  building.heightSource = HeightSource::Attribute;
  if (left_.attributes) {
    building.object.attributes.set("height", look.height);
    building.object.attributes.set("use", std::string(look.use));
    building.object.attributes.set("year", std::int64_t{look.year});
  }
  building.footprint.push_back(std::move(polygon));
  add(std::move(building));
}

void BlockFiller::add(Building building) {
  if (full()) return;
  std::size_t vertices = 0;
  for (const Polygon& polygon : building.footprint) {
    vertices += polygon.outer.size();
    for (const Ring& hole : polygon.holes) vertices += hole.size();
    left_.holes -= static_cast<int>(polygon.holes.size());
  }
  if (left_.steps >= 0) left_.steps -= (static_cast<std::int64_t>(vertices) - 4) / 2;
  --left_.buildings;
  model_.buildings.push_back(std::move(building));
}

}  // namespace lodestone
