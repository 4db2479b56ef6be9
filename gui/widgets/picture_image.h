// Ray-cast pictures as Qt has them.
#pragma once

#include <QImage>

#include "algorithms/rendering/rendering.h"

namespace lodestone {

[[nodiscard]] QImage toImage(const Picture& picture);

}  // namespace lodestone
