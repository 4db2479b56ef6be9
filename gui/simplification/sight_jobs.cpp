#include "gui/simplification/sight_jobs.h"

#include <algorithm>

#include "algorithms/geometry/triangle_tree.h"

namespace lodestone {
namespace {

constexpr int kWidth = 1024, kHeight = 512;  // those of the command line

std::vector<std::uint32_t> targetsOf(const StagedBuilding& staged, const SightOptions& options) {
  const Box3 box = bounds(*staged.mesh);
  std::vector<Reach> reaches;
  if (!box.empty()) reaches.push_back({box.center(), options.distance + box.size().norm() / 2});
  if (options.placed) reaches.push_back({options.eye(), options.distance});
  std::vector<std::uint32_t> without = staged.buildings;
  std::sort(without.begin(), without.end());
  return buildingsWithin(*staged.city, reaches, without);
}

void findTargets(const StagedBuilding& staged, const Seen* earlier, Seen& seen) {
  std::vector<std::uint32_t> targets = targetsOf(staged, seen.options);
  if (earlier && earlier->around->buildings == targets) {
    seen.around = earlier->around;
    seen.triangles = earlier->triangles;
    return;
  }
  auto triangles = std::make_shared<OwnedTriangles>();
  const auto place = [&](std::uint32_t building) {
    return static_cast<std::uint32_t>(std::lower_bound(targets.begin(), targets.end(), building) -
                                      targets.begin());
  };
  addBuildings(*staged.city, targets, place, *triangles);
  seen.triangles = std::move(triangles);
  seen.around =
      makeSurroundings(*staged.city, std::move(targets), static_cast<NodeId>(staged.mesh->components.size()),
                       staged.pane->nodes->anchor);
}

/// By the parity of crossings: of a target that is not closed the answer may be wrong.
std::optional<std::uint32_t> targetAround(const Vec3& eye, const Surroundings& around,
                                          const OwnedTriangles& scene) {
  for (std::uint32_t target = 0; target < around.buildings.size(); ++target) {
    const Box3 box = boxOf(around, target);
    if (box.empty() || (eye.array() < box.min.array()).any() || (eye.array() > box.max.array()).any())
      continue;
    std::vector<TriangleTree::Triangle> own;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      if (scene.owner[t] == target) own.push_back(scene.triangles[t]);
    }
    if (!own.empty() && TriangleTree(scene.vertices, own).encloses(eye)) return target;
  }
  return {};
}

std::size_t countWithin(const Surroundings& around, const SightOptions& options) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < around.buildings.size(); ++i) {
    const Box3 box = boxOf(around, i);
    const Vec3 eye = options.eye();
    if (!box.empty() && (eye.cwiseMax(box.min).cwiseMin(box.max) - eye).norm() <= options.distance) ++count;
  }
  return count;
}

}  // namespace

Viewpoint viewpointOf(const SightOptions& options) {
  return {options.eye(), options.direction(), options.angle, options.distance, kWidth, kHeight};
}

Seen lookPast(const StagedBuilding& staged, const SightOptions& options, const PastModels& models,
              const Seen* earlier, const Progress& progress) {
  Seen seen;
  seen.options = options;
  seen.models = models;
  findTargets(staged, earlier, seen);
  progress.checkpoint();
  if (!options.placed) return seen;
  seen.within = countWithin(*seen.around, options);
  seen.enclosing = targetAround(options.eye(), *seen.around, *seen.triangles);
  const bool sameView = earlier && earlier->options == options && earlier->around == seen.around;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!models[i]) continue;
    if (sameView && earlier->models[i] == models[i]) {
      seen.sightings[i] = earlier->sightings[i];
      continue;
    }
    OwnedTriangles scene = *seen.triangles;
    addMesh(*models[i], kBlocked, scene);
    const auto count = static_cast<double>(models.size());
    const auto place = static_cast<double>(i);
    seen.sightings[i] = std::make_shared<const Sighting>(
        lookFrom(viewpointOf(options), scene, static_cast<std::uint32_t>(seen.around->buildings.size()),
                 progress.part(place / count, (place + 1) / count, "look")));
  }
  return seen;
}

TargetFate fateOf(const Seen& seen, Past past, std::uint32_t target) {
  const auto& original = seen.sightings[static_cast<std::size_t>(Past::Original)];
  const auto& here = seen.sightings[static_cast<std::size_t>(past)];
  if (!original || !here) return TargetFate::Unseen;
  if (here->sees(target)) return original->sees(target) ? TargetFate::Seen : TargetFate::Appeared;
  return original->sees(target) ? TargetFate::Vanished : TargetFate::Unseen;
}

}  // namespace lodestone
