#include "gui/widgets/picture_image.h"

namespace lodestone {

QImage toImage(const Picture& picture) {
  return QImage(picture.rgba.data(), picture.width, picture.height, picture.width * 4,
                QImage::Format_RGBA8888)
      .copy();
}

}  // namespace lodestone
