#include "algorithms/clustering/packed_footprints.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_sort.h>

#include "algorithms/geometry/parallel.h"

namespace lodestone {
namespace {

constexpr std::size_t kGrain = 4096;
constexpr int kHilbertBits = 31;  // an axis; enough that one stray building far away does not spoil the order

/// Place of a cell on the Hilbert curve of order kHilbertBits.
std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y) {
  std::uint64_t index = 0;
  for (std::uint32_t side = 1U << (kHilbertBits - 1); side > 0; side >>= 1U) {
    const bool right = (x & side) != 0;
    const bool upper = (y & side) != 0;
    index = index * 4 + (right ? (upper ? 2 : 3) : (upper ? 1 : 0));
    if (!upper) {  // the curve enters this quadrant turned
      if (right) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

struct Placed {
  std::uint64_t place = 0;
  std::uint32_t building = 0;
  bool operator<(const Placed& other) const {
    return place != other.place ? place < other.place : building < other.building;
  }
};

std::uint32_t firstVertex(const FootprintTable& table, std::size_t building) {
  return table.ringStart[table.buildingRing[building]];
}

Box2 boxOf(const FootprintTable& table, std::size_t building) {
  Box2 box;
  for (std::uint32_t v = firstVertex(table, building); v < firstVertex(table, building + 1); ++v) {
    box.add(table.vertices[v]);
  }
  return box;
}

std::vector<Placed> alongHilbertCurve(const FootprintTable& table, const std::vector<Box2>& boxes) {
  Box2 centres;
  for (const Box2& box : boxes) {
    if (!box.empty()) centres.add(box.center());
  }
  // One building, or several about one centre, have no extent to divide by.
  const double side = centres.empty() ? 0 : centres.size().maxCoeff();
  const double scale = side > 0 ? static_cast<double>((1U << kHilbertBits) - 1U) / side : 0;
  std::vector<Placed> order;
  order.reserve(boxes.size());
  for (std::size_t b = 0; b < table.buildingCount(); ++b) {
    if (boxes[b].empty()) continue;
    const Vec2 cell = (boxes[b].center() - centres.min) * scale;
    order.push_back({hilbertIndex(static_cast<std::uint32_t>(cell.x()), static_cast<std::uint32_t>(cell.y())),
                     static_cast<std::uint32_t>(b)});
  }
  tbb::parallel_sort(order);
  return order;
}

}  // namespace

PackedFootprints packFootprints(const FootprintTable& table, const Progress& progress) {
  std::vector<Box2> boxes(table.buildingCount());
  forPieces(0, boxes.size(), kGrain, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) boxes[b] = boxOf(table, b);
  });
  PackedFootprints packed;
  if (progress.stopRequested()) return packed;
  const std::vector<Placed> order = alongHilbertCurve(table, boxes);
  packed.building.reserve(order.size());
  packed.box.reserve(order.size());
  packed.vertexStart.reserve(order.size() + 1);
  for (const Placed& placed : order) {
    const std::uint32_t b = placed.building;
    packed.building.push_back(b);
    packed.box.push_back(boxes[b]);
    packed.vertexStart.push_back(packed.vertexStart.back() + firstVertex(table, b + 1) -
                                 firstVertex(table, b));
  }
  packed.x.resize(packed.vertexStart.back());
  packed.y.resize(packed.vertexStart.back());
  forPieces(0, order.size(), kGrain, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t slot = first; slot < last; ++slot) {
      const Vec2* from = table.vertices.data() + firstVertex(table, packed.building[slot]);
      for (std::uint32_t v = packed.vertexStart[slot]; v < packed.vertexStart[slot + 1]; ++v, ++from) {
        packed.x[v] = from->x();
        packed.y[v] = from->y();
      }
    }
  });
  return packed;
}

}  // namespace lodestone
