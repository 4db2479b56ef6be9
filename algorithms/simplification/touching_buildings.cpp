#include "algorithms/simplification/touching_buildings.h"

#include <algorithm>
#include <memory>
#include <unordered_map>

#include "algorithms/geometry/box_pairs.h"
#include "algorithms/geometry/components.h"
#include "algorithms/geometry/disjoint_sets.h"
#include "algorithms/geometry/parallel.h"
#include "algorithms/geometry/triangle_tree.h"

namespace lodestone {

std::vector<std::vector<std::uint32_t>> touchingBuildings(const CityModel& city, double reach,
                                                          const Progress& progress) {
  const std::size_t count = city.buildings.size();
  std::vector<ComponentMesh> meshes(count);
  std::vector<Box3> boxes(count);
  forPieces(0, count, 8, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      const auto index = static_cast<std::uint32_t>(b);
      meshes[b] = makeComponentMesh(city, {&index, 1});
      boxes[b] = bounds(meshes[b]);
      if (boxes[b].empty()) continue;
      boxes[b].min.array() -= reach / 2;
      boxes[b].max.array() += reach / 2;
    }
  });
  progress.checkpoint();
  const auto pairs = meetingPairs(boxes);
  std::vector<bool> wanted(count, false);
  for (const auto& [a, b] : pairs) wanted[a] = wanted[b] = true;
  std::vector<std::unique_ptr<TriangleTree>> trees(count);
  forPieces(0, count, 8, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      if (wanted[b]) trees[b] = std::make_unique<TriangleTree>(meshes[b].vertices, meshes[b].triangles);
    }
  });
  std::vector<std::uint8_t> touch(pairs.size(), 0);
  forPieces(0, pairs.size(), 8, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto [a, b] = pairs[i];
      const double beyond = 2 * reach;
      touch[i] = trees[a] && trees[b] && trees[a]->distance(*trees[b], beyond) <= reach ? 1 : 0;
    }
  });
  progress.checkpoint();
  DisjointSets sets(count);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (touch[i] != 0) (void)sets.join(pairs[i].first, pairs[i].second);
  }
  std::vector<std::vector<std::uint32_t>> groups;
  std::unordered_map<std::uint32_t, std::size_t> groupOf;
  for (std::uint32_t b = 0; b < count; ++b) {
    const auto [found, added] = groupOf.try_emplace(sets.find(b), groups.size());
    if (added) groups.emplace_back();
    groups[found->second].push_back(b);
  }
  return groups;
}

std::vector<std::uint32_t> touchingGroup(const CityModel& city, std::uint32_t building, double reach,
                                         const Progress& progress) {
  std::vector<Box3> boxes;
  boxes.reserve(city.buildings.size());
  for (const Building& other : city.buildings) {
    boxes.push_back(bounds(other));
    if (boxes.back().empty()) continue;
    boxes.back().min.array() -= reach / 2;
    boxes.back().max.array() += reach / 2;
  }
  DisjointSets near(boxes.size());
  for (const auto& [a, b] : meetingPairs(boxes)) (void)near.join(a, b);
  progress.checkpoint();
  // Only what hangs together by boxes can touch: the rest of the city is left aside.
  CityModel candidates;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t b = 0; b < boxes.size(); ++b) {
    if (near.find(b) != near.find(building)) continue;
    candidates.buildings.push_back(city.buildings[b]);
    indices.push_back(b);
  }
  for (const auto& group : touchingBuildings(candidates, reach, progress)) {
    std::vector<std::uint32_t> members;
    for (const std::uint32_t member : group) members.push_back(indices[member]);
    if (std::find(members.begin(), members.end(), building) != members.end()) return members;
  }
  return {building};
}

}  // namespace lodestone
