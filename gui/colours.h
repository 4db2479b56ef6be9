// Colours that carry meaning, the same in every panel; told apart by people with any colour vision.
#pragma once

#include <QColor>
#include <QPalette>

#include "model/dendrogram.h"

namespace lodestone {

[[nodiscard]] QColor selectionColour();
[[nodiscard]] QColor cutLineColour();
/// Stable hue of a drawn cluster: from Okabe and Ito's set (2008), toned to the palette's background.
[[nodiscard]] QColor clusterColour(NodeId node, const QPalette& palette);

enum class Appearance { System, Light, Dark };
/// Palette of an appearance; System: the one the desktop gave at start.
[[nodiscard]] QPalette paletteOf(Appearance appearance);
[[nodiscard]] bool isDark(const QPalette& palette);

}  // namespace lodestone
