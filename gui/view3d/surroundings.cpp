#include "gui/view3d/surroundings.h"

#include <algorithm>

#include <tbb/parallel_for.h>

namespace lodestone {
namespace {

double distanceTo(const Box3& box, const Vec3& point) {
  return (point.cwiseMax(box.min).cwiseMin(box.max) - point).norm();
}

}  // namespace

const Rgb& targetColour(TargetFate fate, const Palette& palette) {
  switch (fate) {
    case TargetFate::Seen:
      return palette.seen;
    case TargetFate::Appeared:
      return palette.appeared;
    case TargetFate::Vanished:
      return palette.vanished;
    case TargetFate::Unseen:
      break;
  }
  return palette.unseen;
}

std::vector<std::uint32_t> buildingsWithin(const CityModel& city, std::span<const Reach> reaches,
                                           std::span<const std::uint32_t> without) {
  std::vector<std::uint8_t> near(city.buildings.size());
  tbb::parallel_for(std::size_t{0}, near.size(), [&](std::size_t b) {
    const Box3 box = bounds(city.buildings[b]);
    near[b] = !box.empty() && std::any_of(reaches.begin(), reaches.end(), [&](const Reach& reach) {
      return distanceTo(box, reach.centre) <= reach.radius;
    });
  });
  std::vector<std::uint32_t> found;
  for (std::uint32_t b = 0; b < near.size(); ++b) {
    if (near[b] != 0 && !std::binary_search(without.begin(), without.end(), b)) found.push_back(b);
  }
  return found;
}

std::shared_ptr<const Surroundings> makeSurroundings(const CityModel& city,
                                                     std::vector<std::uint32_t> buildings, NodeId firstNode,
                                                     const Vec3& anchor) {
  auto around = std::make_shared<Surroundings>();
  around->buildings = std::move(buildings);
  around->mesh = meshBuildings(city, around->buildings, firstNode, anchor);
  for (std::size_t i = 0; i < around->buildings.size(); ++i) {
    const Box3 box = boxOf(*around, i);
    if (box.empty()) continue;
    around->nodes.push_back(firstNode + static_cast<NodeId>(i));
    around->bounds.add(box);
  }
  return around;
}

Box3 boxOf(const Surroundings& around, std::size_t target) {
  const MeshBox& box = around.mesh.boxes[target];
  if (box.empty()) return {};
  return {around.mesh.anchor + Vec3(box.min[0], box.min[1], box.min[2]),
          around.mesh.anchor + Vec3(box.max[0], box.max[1], box.max[2])};
}

}  // namespace lodestone
