// The colour and outline of every node that is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gui/view3d/palette.h"
#include "gui/view3d/scene_geometry.h"

namespace lodestone {

/// What decides the colours of a scene.
struct NodeColouring {
  const Palette& palette;
  bool dark = false;
  bool byCluster = false;       ///< a stable hue for each cluster, instead of one for all
  bool showLandmarks = false;   ///< landmarks in a colour of their own
  std::optional<Rgb> building;  ///< instead of the palette's
  std::optional<Rgb> context;
  std::span<const NodeId> selection;
  NodeId hover = kNoNode;
};

/// Colours and outline marks by NodeId, as CityProp::setColours() takes them; the last entry is that of
/// everything that is no building. `geometry` may be null. Cost: O(nodes).
[[nodiscard]] std::vector<std::array<std::uint8_t, 4>> nodeColours(const SceneGeometry* geometry,
                                                                   std::span<const DrawnNode> drawn,
                                                                   const NodeColouring& colouring);

}  // namespace lodestone
