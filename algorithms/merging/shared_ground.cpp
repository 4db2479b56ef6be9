#include "algorithms/merging/shared_ground.h"

#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include "algorithms/geometry/close_segments.h"
#include "algorithms/geometry/disjoint_sets.h"
#include "algorithms/geometry/overlap_area.h"

namespace lodestone {
namespace {

using Building = std::uint32_t;

/// Two buildings that overlap, the one below child a first, and the node in which they meet.
struct Pair {
  NodeId node = kNoNode;
  Building inA = 0;
  Building inB = 0;
  double area = 0;
};

/// Overlaps below this are noise of coordinates: neighbours whose common wall was measured twice.
constexpr double kNoOverlap = 1e-9;

std::vector<Box2> boxesOf(const FootprintTable& footprints) {
  std::vector<Box2> boxes(footprints.buildingCount());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t r = footprints.buildingRing[i]; r < footprints.buildingRing[i + 1]; ++r) {
      for (std::uint32_t v = footprints.ringStart[r]; v < footprints.ringStart[r + 1]; ++v)
        boxes[i].add(footprints.vertices[v]);
    }
  }
  return boxes;
}

/// Adds a building's sides. Rings have the inside on their left as they stand.
void addSides(const FootprintTable& footprints, Building building, std::uint8_t set,
              std::vector<OverlapSide>& sides) {
  for (std::uint32_t r = footprints.buildingRing[building]; r < footprints.buildingRing[building + 1]; ++r) {
    const std::uint32_t begin = footprints.ringStart[r];
    const std::uint32_t end = footprints.ringStart[r + 1];
    for (std::uint32_t v = begin; v < end; ++v) {
      sides.push_back({footprints.vertices[v], footprints.vertices[v + 1 == end ? begin : v + 1], set});
    }
  }
}

/// A grid over the plan; a building is listed in every cell that its box touches.
class BuildingGrid {
 public:
  explicit BuildingGrid(const std::vector<Box2>& boxes) : boxes_(boxes) {
    double extent = 0;
    std::size_t count = 0;
    for (const Box2& box : boxes) {
      if (box.empty()) continue;
      all_.add(box);
      extent += box.size().maxCoeff();
      ++count;
    }
    if (count == 0) return;
    constexpr double kMostCells = 4096;  // a side: a lone far building must not make the cells innumerable
    cell_ = std::max({2 * extent / static_cast<double>(count), all_.size().maxCoeff() / kMostCells, 1e-9});
    columns_ = static_cast<std::uint64_t>(all_.size().x() / cell_) + 1;
    for (Building i = 0; i < boxes.size(); ++i) {
      if (!boxes[i].empty()) forCells(boxes[i], [&](std::uint64_t cell) { entries_.emplace_back(cell, i); });
    }
    tbb::parallel_sort(entries_.begin(), entries_.end());
  }

  /// Calls `visit(i, j)`, i < j, once for each pair whose boxes share more than a border and whose first such
  /// cell starts at entry k.
  template <class Visit>
  void forPairsAt(std::size_t k, const Visit& visit) const {
    const auto [cell, i] = entries_[k];
    for (std::size_t m = k + 1; m < entries_.size() && entries_[m].first == cell; ++m) {
      const Building j = entries_[m].second;
      const Vec2 low = boxes_[i].min.cwiseMax(boxes_[j].min);
      const Vec2 high = boxes_[i].max.cwiseMin(boxes_[j].max);
      if ((low.array() < high.array()).all() && cellOf(low) == cell) visit(i, j);
    }
  }
  [[nodiscard]] std::size_t entryCount() const { return entries_.size(); }

 private:
  [[nodiscard]] std::uint64_t column(double x) const {
    return static_cast<std::uint64_t>((x - all_.min.x()) / cell_);
  }
  [[nodiscard]] std::uint64_t row(double y) const {
    return static_cast<std::uint64_t>((y - all_.min.y()) / cell_);
  }
  [[nodiscard]] std::uint64_t cellOf(const Vec2& p) const { return row(p.y()) * columns_ + column(p.x()); }
  template <class Visit>
  void forCells(const Box2& box, const Visit& visit) const {
    for (std::uint64_t y = row(box.min.y()); y <= row(box.max.y()); ++y) {
      for (std::uint64_t x = column(box.min.x()); x <= column(box.max.x()); ++x) visit(y * columns_ + x);
    }
  }

  const std::vector<Box2>& boxes_;
  Box2 all_;
  double cell_ = 1;
  std::uint64_t columns_ = 1;
  std::vector<std::pair<std::uint64_t, Building>> entries_;
};

/// All overlapping pairs, without their nodes.
std::vector<Pair> overlappingPairs(const FootprintTable& footprints, const std::vector<Box2>& boxes,
                                   const Progress& progress) {
  const BuildingGrid grid(boxes);
  std::vector<std::vector<Pair>> found((grid.entryCount() + 4095) / 4096);
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t chunk) {
    std::vector<OverlapSide> sides;
    const std::size_t end = std::min((chunk + 1) * 4096, grid.entryCount());
    for (std::size_t k = chunk * 4096; k < end && !progress.stopRequested(); ++k) {
      grid.forPairsAt(k, [&](Building i, Building j) {
        sides.clear();
        addSides(footprints, i, 0, sides);
        addSides(footprints, j, 1, sides);
        const double area = overlapArea(sides);
        if (area > kNoOverlap) found[chunk].push_back({kNoNode, i, j, area});
      });
    }
  });
  std::vector<Pair> pairs;
  for (const std::vector<Pair>& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  return pairs;
}

/// Finds where each pair meets. A parent's number is larger than its children's, so the smaller of two nodes
/// climbs.
void findNodes(const Dendrogram& dendrogram, std::vector<Pair>& pairs) {
  const std::vector<NodeId> parent = parents(dendrogram);
  tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t k) {
    NodeId x = pairs[k].inA;
    NodeId y = pairs[k].inB;
    NodeId belowX = x;
    while (x != y && x != kNoNode && y != kNoNode) {
      if (x < y) {
        belowX = x;
        x = parent[x];
      } else {
        y = parent[y];
      }
    }
    if (x != y || x == kNoNode) return;
    pairs[k].node = x;
    if (dendrogram.merge(x).a != belowX) std::swap(pairs[k].inA, pairs[k].inB);
  });
}

/// Numbers pairs that have to be looked at together: those that share a building or may overlap each other.
DisjointSets groupsOf(const Pair* first, std::size_t count, const std::vector<Box2>& boxes) {
  DisjointSets groups(count);
  const auto joinEqual = [&](const auto& buildingOf) {
    std::vector<std::pair<Building, std::uint32_t>> order;
    for (std::uint32_t k = 0; k < count; ++k) order.emplace_back(buildingOf(first[k]), k);
    std::sort(order.begin(), order.end());
    for (std::size_t k = 1; k < count; ++k) {
      if (order[k].first == order[k - 1].first) (void)groups.join(order[k].second, order[k - 1].second);
    }
  };
  joinEqual([](const Pair& pair) { return pair.inA; });
  joinEqual([](const Pair& pair) { return pair.inB; });
  const auto commonBox = [&](std::size_t k) {
    const Box2& a = boxes[first[k].inA];
    const Box2& b = boxes[first[k].inB];
    return std::pair<Vec2, Vec2>(a.min.cwiseMax(b.min), a.max.cwiseMin(b.max));
  };
  forCloseSegments(count, commonBox, [&](std::size_t i, std::size_t j) {
    (void)groups.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
    return true;
  });
  return groups;
}

double groupArea(const FootprintTable& footprints, const std::vector<const Pair*>& pairs) {
  if (pairs.size() == 1) return pairs[0]->area;
  std::vector<OverlapSide> sides;
  for (const std::uint8_t set : {std::uint8_t{0}, std::uint8_t{1}}) {
    std::vector<Building> buildings;
    for (const Pair* pair : pairs) buildings.push_back(set == 0 ? pair->inA : pair->inB);
    std::sort(buildings.begin(), buildings.end());
    buildings.erase(std::unique(buildings.begin(), buildings.end()), buildings.end());
    for (const Building building : buildings) addSides(footprints, building, set, sides);
  }
  return overlapArea(sides);
}

/// Area shared at one node, of all its pairs.
double nodeArea(const FootprintTable& footprints, const Pair* first, std::size_t count,
                const std::vector<Box2>& boxes) {
  if (count == 1) return first->area;
  DisjointSets groups = groupsOf(first, count, boxes);
  std::vector<std::vector<const Pair*>> members(count);
  for (std::size_t k = 0; k < count; ++k)
    members[groups.find(static_cast<std::uint32_t>(k))].push_back(first + k);
  double sum = 0;
  for (const auto& group : members) {
    if (!group.empty()) sum += groupArea(footprints, group);
  }
  return sum;
}

}  // namespace

std::vector<double> sharedGround(const FootprintTable& footprints, const Dendrogram& dendrogram,
                                 const Progress& progress) {
  const std::vector<Box2> boxes = boxesOf(footprints);
  std::vector<Pair> pairs = overlappingPairs(footprints, boxes, progress);
  findNodes(dendrogram, pairs);
  std::erase_if(pairs, [](const Pair& pair) { return pair.node == kNoNode; });
  std::sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) {
    if (x.node != y.node) return x.node < y.node;
    return x.inA != y.inA ? x.inA < y.inA : x.inB < y.inB;
  });
  std::vector<std::size_t> start;  // of each node's pairs
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (k == 0 || pairs[k].node != pairs[k - 1].node) start.push_back(k);
  }
  start.push_back(pairs.size());
  std::vector<double> shared(dendrogram.nodeCount(), 0);
  tbb::parallel_for(std::size_t{1}, start.size(), [&](std::size_t k) {
    if (progress.stopRequested()) return;
    const Pair* first = pairs.data() + start[k - 1];
    shared[first->node] = nodeArea(footprints, first, start[k] - start[k - 1], boxes);
  });
  return shared;
}

}  // namespace lodestone
