// The colours of the 3D view: ours, and told apart by colour-blind people too.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "model/cluster_tree.h"

namespace lodestone {

using Rgb = std::array<float, 3>;  ///< display values, 0–1

enum class SceneTheme { Light, Dark };

struct Palette {
  Rgb skyTop, skyHorizon, ground, grid, ink;
  Rgb building, cluster, landmark, context;
  Rgb selection, hover;          ///< tints
  Rgb selectionLine, hoverLine;  ///< outlines
  Rgb hullLine, boxLine, street, rail, water;
  Rgb unseen, seen, appeared, vanished;  ///< targets of a visibility analysis
  Rgb sight;                             ///< its viewpoint and what lies within it
};

[[nodiscard]] const Palette& lightPalette();
[[nodiscard]] const Palette& darkPalette();

/// Hues of which any two differ in lightness or along the blue–yellow axis. \pre i < kHueCount
inline constexpr std::size_t kHueCount = 12;
[[nodiscard]] Rgb hueOf(std::size_t i);

/// A stable hue for a cluster: the same from cut to cut, neighbours in number far apart in hue and in
/// lightness.
[[nodiscard]] Rgb clusterColour(NodeId node);

}  // namespace lodestone
