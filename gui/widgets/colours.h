// Colours that carry meaning, the same in every panel; told apart by people with any colour vision.
#pragma once

#include <QColor>
#include <QPalette>

#include "model/dendrogram.h"

namespace lodestone {

[[nodiscard]] QColor selectionColour();
[[nodiscard]] QColor cutLineColour();
/// The hue that the 3D view gives a drawn cluster when it colours by cluster.
[[nodiscard]] QColor clusterColour(NodeId node, const QPalette& palette);

/// The first colour with `share` (0 to 1) of the second.
[[nodiscard]] QColor mixed(const QColor& a, const QColor& b, double share);

enum class Appearance { System, Light, Dark };
/// Palette of an appearance; System: the one the desktop gave at start.
[[nodiscard]] QPalette paletteOf(Appearance appearance);
[[nodiscard]] bool isDark(const QPalette& palette);

}  // namespace lodestone
