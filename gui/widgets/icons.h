// The icons of resources/icons, drawn in the colours of the palette, dark or light.
#pragma once

#include <QIcon>
#include <QString>

namespace lodestone {

/// Icon of the given name ("open"): its lines in the palette's text colour, its accents in the accent colour.
[[nodiscard]] QIcon icon(const QString& name);
/// One hue for accents, the same in dark and light: readable on both.
[[nodiscard]] QColor accentColor();

}  // namespace lodestone
