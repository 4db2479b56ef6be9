// Classes of detail for people: their names, and their colours as Qt has them.
#pragma once

#include <QColor>
#include <QString>
#include <array>

#include "model/detail_colours.h"

namespace lodestone {

inline constexpr std::array<DetailClass, kDetailClasses> kAllDetail{
    DetailClass::None, DetailClass::Slight, DetailClass::Moderate, DetailClass::Dramatic};

/// "None", "Slight", …
[[nodiscard]] QString nameOf(DetailClass detailClass);
[[nodiscard]] QColor colourOf(DetailClass detailClass);
[[nodiscard]] QColor colourOfUnseen();

}  // namespace lodestone
