// A hierarchy that needs no clustering: buildings halved by their centres, again and again.
#pragma once

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

#include "model/dendrogram.h"
#include "model/footprint_table.h"

namespace lodestone::test {

/// Balanced, with neighbours together; weights rise from the leaves to the root. The split leaves a remainder
/// of one in `skew` to one side, so that depths differ.
inline Dendrogram plainDendrogram(const FootprintTable& footprints, int skew = 2) {
  const auto count = static_cast<std::uint32_t>(footprints.buildingCount());
  std::vector<Vec2> centre(count, Vec2::Zero());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t ring = footprints.buildingRing[i];
    if (ring < footprints.buildingRing[i + 1]) centre[i] = footprints.vertices[footprints.ringStart[ring]];
  }
  Dendrogram dendrogram;
  dendrogram.leafCount = count;
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  const auto build = [&](std::size_t begin, std::size_t end, const auto& self) -> NodeId {
    if (end - begin == 1) return order[begin];
    Box2 box;
    for (std::size_t k = begin; k < end; ++k) box.add(centre[order[k]]);
    const int axis = box.size().x() > box.size().y() ? 0 : 1;
    const std::size_t middle =
        begin + std::max<std::size_t>(1, (end - begin) / static_cast<std::size_t>(skew));
    std::nth_element(order.begin() + static_cast<std::ptrdiff_t>(begin),
                     order.begin() + static_cast<std::ptrdiff_t>(middle),
                     order.begin() + static_cast<std::ptrdiff_t>(end), [&](std::uint32_t a, std::uint32_t b) {
                       return centre[a][axis] != centre[b][axis] ? centre[a][axis] < centre[b][axis] : a < b;
                     });
    const NodeId a = self(begin, middle, self);
    const NodeId b = self(middle, end, self);
    Merge merge{a, b};
    merge.size = static_cast<std::uint32_t>(end - begin);
    merge.weight = static_cast<double>(dendrogram.merges.size() + 1);
    dendrogram.merges.push_back(merge);
    return dendrogram.nodeCount() - 1;
  };
  if (count > 0) build(0, count, build);
  dendrogram.depth = depthOf(dendrogram);
  return dendrogram;
}

}  // namespace lodestone::test
