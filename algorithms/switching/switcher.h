// What of a city is drawn, picture by picture, by one rule or another (resources/docs/methods.md, 1.4 and 4).
#pragma once

#include <memory>

#include "algorithms/switching/building_levels.h"
#include "model/cluster_tree.h"

namespace lodestone {

/// One viewer's rule; not safe to call from several threads at once.
class Switcher {
 public:
  Switcher() = default;
  Switcher(const Switcher&) = delete;
  Switcher& operator=(const Switcher&) = delete;
  virtual ~Switcher() = default;

  /// What is drawn from a camera; stands until the next call. Deterministic: what came before does not count.
  virtual const Cut& pick(const Camera& camera) = 0;
};

/// Legible LOD (makeCut()).
[[nodiscard]] std::unique_ptr<Switcher> legibleSwitcher(std::shared_ptr<const ClusterTree> tree,
                                                        const CutOptions& options);
/// Every building that the picture may show, found by the boxes of the tree's nodes.
[[nodiscard]] std::unique_ptr<Switcher> visibleSwitcher(std::shared_ptr<const ClusterTree> tree);
/// Every building, always.
[[nodiscard]] std::unique_ptr<Switcher> everythingSwitcher(std::shared_ptr<const ClusterTree> tree);

/// By the distance of the eye to the middle of a building: every building in the picture, at the level that
/// BuildingLevels::distances() gives it.
[[nodiscard]] std::unique_ptr<Switcher> rangeSwitcher(std::shared_ptr<const ClusterTree> tree,
                                                      std::shared_ptr<const BuildingLevels> levels);
/// By the building's own prism: a level is drawn while the eye is no farther from the block over the
/// footprint than the level's distance less half of the building's diagonal. So a long block switches by its
/// shape; and never is a finer level drawn than by range. (A prism with rounded edges: with sharp ones that
/// would not hold at its corners.)
[[nodiscard]] std::unique_ptr<Switcher> prismSwitcher(std::shared_ptr<const ClusterTree> tree,
                                                      std::shared_ptr<const BuildingLevels> levels);

}  // namespace lodestone
