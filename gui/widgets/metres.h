// Lengths for people.
#pragma once

#include <QLocale>
#include <QString>
#include <cmath>

namespace lodestone {

/// Three digits that count, in metres or below a centimetre in millimetres.
[[nodiscard]] inline QString metresText(double metres) {
  if (std::abs(metres) < 5e-7) return QStringLiteral("0 m");  // the noise of coordinates
  if (std::abs(metres) < 0.01) return QLocale().toString(metres * 1000, 'g', 3) + QStringLiteral(" mm");
  return QLocale().toString(metres, 'f', std::abs(metres) < 10 ? 3 : 2) + QStringLiteral(" m");
}

}  // namespace lodestone
