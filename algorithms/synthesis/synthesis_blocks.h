// Filling the blocks of a made-up city with buildings.
#pragma once

#include <cstdint>
#include <string_view>

#include "algorithms/synthesis/synthesis_shapes.h"
#include "model/city_model.h"

namespace lodestone {

/// How a block is built up.
enum class BlockKind { Rows, Detached, Courtyards, Towers, Halls };

/// What the counts of a whole city ask for; negative `steps`: outlines come as they fall.
struct SynthBudget {
  std::int64_t buildings = 0;
  std::int64_t steps = -1;  ///< pairs of ground vertices beyond four a building, holes included
  int holes = 0;            ///< hole rings
  bool attributes = false;  ///< use and year beside the height
};

/// Adds buildings to a model until the budget is spent to the last building, vertex and hole.
class BlockFiller {
 public:
  BlockFiller(CityModel& model, const SynthBudget& budget) : model_(model), left_(budget) {}

  [[nodiscard]] bool full() const { return left_.buildings <= 0; }
  /// Buildings that would reach out of `limits` are left out. \pre the block is at least 30 m by 30 m
  void fill(BlockKind kind, const Lattice& lattice, const LatticeRect& block, const Box2& limits,
            SynthRandom& random);
  /// A building of its own making; takes its vertices from the budget.
  void add(Building building);

 private:
  struct Look {
    double height;
    std::string_view use;
    int year;
  };
  void fillRows(const Lattice& lattice, const LatticeRect& block, SynthRandom& random);
  void fillRow(const Lattice& lattice, const LatticeRect& block, int away, SynthRandom& random);
  void fillDetached(const Lattice& lattice, const LatticeRect& block, SynthRandom& random);
  void fillCourtyards(const Lattice& lattice, const LatticeRect& block, SynthRandom& random);
  void fillTowers(const Lattice& lattice, const LatticeRect& block, SynthRandom& random);
  void fillHalls(const Lattice& lattice, const LatticeRect& block, SynthRandom& random);
  void addStepped(const Lattice& lattice, const Frontage& lot, int depth, const Look& look,
                  SynthRandom& random);
  void addPolygon(Polygon polygon, const Look& look);
  int drawJogs(int most, SynthRandom& random) const;

  CityModel& model_;
  SynthBudget left_;
  Box2 limits_;
};

}  // namespace lodestone
