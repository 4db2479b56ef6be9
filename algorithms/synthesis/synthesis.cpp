#include "algorithms/synthesis/synthesis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/synthesis/synthesis_blocks.h"
#include "algorithms/synthesis/synthesis_grid.h"
#include "algorithms/synthesis/synthesis_landmark.h"

namespace lodestone {

template <>
const std::vector<Field<SynthOptions>>& fields<SynthOptions>() {
  using O = SynthOptions;
  static const std::vector<Field<O>> table{
      choice(&O::preset, "preset", "Preset", {"town", "xinxiang", "charlotte", "grid400"},
             "Town: a small town with attributes, courtyards and a church. Xinxiang, Charlotte: cities with "
             "the building and "
             "vertex counts of table 1 in Chang et al. 2008. Grid400: four kinds of buildings of four levels "
             "each "
             "on a grid of 20 × 20 plots, as in Polys et al. 2016."),
      integer(&O::buildings, "buildings", "Buildings", "", 0, 10'000'000,
              "Number of buildings. 0: the preset's own."),
      integer(&O::seed, "seed", "Seed", "", 0, 2'147'483'647,
              "The same seed makes the same city everywhere."),
  };
  return table;
}

namespace {

/// What makes one preset different from the next.
struct Plan {
  std::int64_t buildings;
  std::int64_t groundVertices;  ///< of all buildings; 0: as they fall
  int holes;
  double cell;                   ///< side of a district, metres
  double blockShort, blockLong;  ///< greatest block depth and length, metres
  double perDistrict;            ///< buildings in a district, about
  bool town;
};

// Counts: Chang et al. 2008, table 1 (and its text for the hole rings).
Plan planOf(CityPreset preset) {
  switch (preset) {
    case CityPreset::Town:
      return {600, 0, 6, 200, 52, 84, 44, true};
    case CityPreset::Xinxiang:
      return {95'042, 502'336, 2, 480, 64, 130, 250, false};
    case CityPreset::Charlotte:
      return {369'929, 2'414'056, 0, 512, 68, 150, 250, false};
    case CityPreset::Grid400:
      break;
  }
  return {400, 0, 0, 0, 0, 0, 0, false};  // its own plan
}

SynthBudget budgetOf(const Plan& plan, std::int64_t buildings) {
  SynthBudget budget{buildings, -1, plan.holes, plan.town};
  if (plan.groundVertices > 0) {
    const std::int64_t steps = (plan.groundVertices - 4 * plan.buildings) / 2;
    budget.steps = steps * buildings / plan.buildings;
    budget.holes = static_cast<int>(std::min<std::int64_t>(plan.holes, budget.steps / 2));
  }
  return budget;
}

struct Cell {
  int x = 0;
  int y = 0;
};

/// Cells of a square grid by distance from the middle, ring after ring, without end.
class CellsOutward {
 public:
  explicit CellsOutward(int seed) : random_(static_cast<std::uint64_t>(seed)) {}
  Cell next() {
    while (position_ == ring_.size()) makeRing();
    return ring_[position_++];
  }

 private:
  void makeRing() {
    ring_.clear();
    position_ = 0;
    const int r = radius_++;
    for (int y = -r; y <= r; ++y) {
      for (int x = -r; x <= r; ++x) {
        const int squared = x * x + y * y;
        if (squared <= r * r && (r == 0 || squared > (r - 1) * (r - 1))) ring_.push_back({x, y});
      }
    }
    // Shuffled, so that a city which ends in the middle of a ring has no straight side.
    for (std::size_t i = ring_.size(); i > 1; --i) {
      std::swap(ring_[i - 1], ring_[static_cast<std::size_t>(random_.between(0, static_cast<int>(i) - 1))]);
    }
  }

  SynthRandom random_;
  std::vector<Cell> ring_;
  std::size_t position_ = 0;
  int radius_ = 0;
};

/// One square district between avenues, with its own grid of streets.
class District {
 public:
  District(const Plan& plan, Cell cell, int seed, double centrality)
      : plan_(plan),
        cell_(cell),
        centrality_(centrality),
        random_(static_cast<std::uint64_t>(seed), cell.x, cell.y) {
    const auto side = static_cast<std::int64_t>(plan.cell * Lattice::kUnitsPerMetre);
    lattice_.originX = side * cell.x;
    lattice_.originY = side * cell.y;
    middle_ = lattice_.world(0, 0);
    limits_.add(middle_ - Vec2::Constant(plan.cell / 2 - kVerge));
    limits_.add(middle_ + Vec2::Constant(plan.cell / 2 - kVerge));
    if (!central() && random_.chance(30)) turn();
    kind_ = chooseKind();
  }

  void build(BlockFiller& filler, LineLayer& streets) {
    // A turned grid must reach into the corners of the square.
    const double reach = plan_.cell * (lattice_.c == 1 ? 0.5 : 0.75);
    const auto columns = cutLine(reach, 0.55 * plan_.blockLong, plan_.blockLong);
    const auto rows = cutLine(reach, 0.7 * plan_.blockShort, plan_.blockShort);
    addStreets(columns, rows, streets);
    for (std::size_t j = 0; j < rows.size(); ++j) {
      for (std::size_t i = 0; i < columns.size() && !filler.full(); ++i) {
        const LatticeRect block{columns[i].begin, rows[j].begin, columns[i].end, rows[j].end};
        const bool middle = i == columns.size() / 2 && j == rows.size() / 2;
        if (plan_.town && central() && middle) {
          addChurch(filler, block);
        } else if (!random_.chance(3)) {  // the rest stays a park
          fillBlock(filler, block);
        }
      }
    }
  }

 private:
  struct Span {
    std::int64_t begin, end;
  };
  static constexpr double kVerge = 8;  ///< from the middle of an avenue to the first wall, metres

  // Some blocks have their houses along the cross streets: the same block on a lattice turned by 90°.
  void fillBlock(BlockFiller& filler, const LatticeRect& block) {
    const BlockKind kind = blockKind();
    if (!random_.chance(30)) {
      filler.fill(kind, lattice_, block, limits_, random_);
      return;
    }
    Lattice across = lattice_;
    across.p = -lattice_.q;
    across.q = lattice_.p;
    filler.fill(kind, across, {block.b0, -block.a1, block.b1, -block.a0}, limits_, random_);
  }

  [[nodiscard]] bool central() const { return cell_.x == 0 && cell_.y == 0; }

  void turn() {
    constexpr std::array<std::array<int, 3>, 4> kTriples{{{4, 3, 5}, {3, 4, 5}, {12, 5, 13}, {5, 12, 13}}};
    const auto& t = kTriples[static_cast<std::size_t>(random_.between(0, plan_.town ? 1 : 3))];
    lattice_.p = t[0];
    lattice_.q = t[1];
    lattice_.c = t[2];
  }

  BlockKind chooseKind() {
    if (plan_.town) return central() || centrality_ < 0.62 ? BlockKind::Rows : BlockKind::Detached;
    if (centrality_ < 0.10 || random_.chance(1)) return BlockKind::Towers;
    if (random_.chance(6)) return BlockKind::Halls;
    return centrality_ < 0.5 + random_.between(-10, 10) / 100.0 ? BlockKind::Rows : BlockKind::Detached;
  }

  // Single blocks differ from their district: offices among rows, rows among houses, yards in the middle.
  BlockKind blockKind() {
    const int roll = random_.between(0, 99);
    if (kind_ == BlockKind::Rows && roll < 25) return BlockKind::Courtyards;
    if (kind_ == BlockKind::Rows && roll < (plan_.town ? 29 : 32)) return BlockKind::Towers;
    if (kind_ == BlockKind::Detached && roll < 8) return BlockKind::Rows;
    if (kind_ == BlockKind::Detached && roll < 11) return BlockKind::Halls;
    if (kind_ == BlockKind::Towers && roll < 20) return BlockKind::Courtyards;
    return kind_;
  }

  /// Blocks along one direction with streets of 9 to 14 m between them, in the middle of [−reach, reach].
  std::vector<Span> cutLine(double reach, double shortest, double longest) {
    std::vector<Span> spans;
    const std::int64_t room = 2 * static_cast<std::int64_t>(lattice_.steps(reach - kVerge));
    std::int64_t at = 0;
    while (true) {
      const int length = lattice_.between(random_, shortest, longest);
      if (at + length > room) break;
      spans.push_back({at, at + length});
      at += length + lattice_.between(random_, 9, 14);
    }
    // What is left over goes to the last block and to both ends.
    spans.back().end += std::min<std::int64_t>((room - spans.back().end) / 2, lattice_.steps(shortest / 2));
    const std::int64_t shift = -spans.back().end / 2;
    for (Span& span : spans) span = {span.begin + shift, span.end + shift};
    return spans;
  }

  void addStreets(const std::vector<Span>& columns, const std::vector<Span>& rows, LineLayer& streets) const {
    const double h = plan_.cell / 2;
    addStreet(streets, middle_ + Vec2(-h, h), middle_ + Vec2(h, h), "primary");
    addStreet(streets, middle_ + Vec2(h, -h), middle_ + Vec2(h, h), "primary");
    const std::int64_t far = lattice_.steps(plan_.cell);
    for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
      const std::int64_t a = (columns[i].end + columns[i + 1].begin) / 2;
      addClipped(streets, lattice_.world(a, -far), lattice_.world(a, far));
    }
    for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
      const std::int64_t b = (rows[j].end + rows[j + 1].begin) / 2;
      addClipped(streets, lattice_.world(-far, b), lattice_.world(far, b));
    }
  }

  static void addStreet(LineLayer& streets, const Vec2& from, const Vec2& to, const char* kind) {
    streets.lines.push_back({from, to});
    streets.kinds.emplace_back(kind);
  }

  /// The part of a line in the district's square (Liang and Barsky's way of clipping).
  void addClipped(LineLayer& streets, const Vec2& from, const Vec2& to) const {
    double begin = 0;
    double end = 1;
    for (int axis = 0; axis < 2; ++axis) {
      const double direction = to[axis] - from[axis];
      for (const int side : {-1, 1}) {
        const double room = middle_[axis] * side + plan_.cell / 2 - from[axis] * side;
        const double speed = direction * side;
        if (speed > 0) end = std::min(end, room / speed);
        if (speed < 0) begin = std::max(begin, room / speed);
        if (speed == 0 && room < 0) return;
      }
    }
    if (begin >= end) return;
    addStreet(streets, from + begin * (to - from), from + end * (to - from), "residential");
  }

  void addChurch(BlockFiller& filler, const LatticeRect& block) const {
    const ChurchSize size;
    const Vec2 middle = lattice_.world((block.a0 + block.a1) / 2, (block.b0 + block.b1) / 2);
    Building church;
    church.object.id = "landmark-church";
    church.object.type = ObjectType::Building;
    const double shift = (size.naveLength - size.towerSide) / 2;
    church.object.geometries.push_back(makeChurch(size, {middle.x() - shift, middle.y(), 0}));
    const Geometry& geometry = church.object.geometries.front();
    Ring ground;
    for (std::uint32_t i = geometry.ringStart[0]; i < geometry.ringStart[1]; ++i) {
      ground.push_back(geometry.vertices[geometry.ringVertices[i]].head<2>());
    }
    tidyRing(ground, true);
    church.footprint.push_back({std::move(ground), {}});
    church.height = size.spireTop;
    church.heightSource = HeightSource::Geometry;
    church.object.attributes.set("height", church.height);
    church.object.attributes.set("use", std::string("religious"));
    church.object.attributes.set("year", std::int64_t{1482});
    church.object.attributes.set("name", std::string("Lodestar Church"));
    filler.add(std::move(church));
  }

  const Plan& plan_;
  Cell cell_;
  double centrality_;
  SynthRandom random_;
  Lattice lattice_;
  Vec2 middle_;
  Box2 limits_;  ///< of its buildings
  BlockKind kind_ = BlockKind::Rows;
};

}  // namespace

CityModel synthesiseCity(const SynthOptions& options, const Progress& progress) {
  const Plan plan = planOf(options.preset);
  const std::int64_t wanted = options.buildings > 0 ? options.buildings : plan.buildings;
  CityModel model;
  model.crs = {"https://www.opengis.net/def/crs/EPSG/0/25832", "ETRS89 / UTM zone 32N", 25832, 0,
               CrsKind::Projected};
  model.origin = Vec3(600'000, 5'700'000, 100);
  model.buildings.reserve(static_cast<std::size_t>(wanted));
  if (options.preset == CityPreset::Grid400) {
    addGridCity(model, static_cast<int>(wanted), options.seed);
    return model;
  }
  LineLayer streets;
  streets.name = "streets";

  BlockFiller filler(model, budgetOf(plan, wanted));
  // A disc of districts holds them all: the share of its radius says how central a district is.
  const double districts = static_cast<double>(wanted) / plan.perDistrict;
  const double radius = std::max(1.0, std::sqrt(districts / 3.14159));
  CellsOutward cells(options.seed);
  while (!filler.full()) {
    const Cell cell = cells.next();
    const double distance = std::sqrt(static_cast<double>(cell.x * cell.x + cell.y * cell.y));
    District(plan, cell, options.seed, distance / radius).build(filler, streets);
    progress.report(static_cast<double>(model.buildings.size()) / static_cast<double>(wanted));
    progress.checkpoint();
  }
  model.lines.push_back(std::move(streets));
  return model;
}

}  // namespace lodestone
