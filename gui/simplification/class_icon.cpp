#include "gui/simplification/class_icon.h"

#include <QPainter>

#include "gui/view3d/component_colours.h"

namespace lodestone {

QIcon classIcon(VertexClass vertexClass) {
  QPixmap picture(32, 32);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const Rgb rgb = classColour(vertexClass);
  const QColor colour = QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
  painter.setBrush(colour);
  painter.setPen(QPen(colour.darker(250), 3));
  if (vertexClass == VertexClass::Hole) {
    painter.drawRect(QRectF(8, 8, 16, 16));
  } else {
    const double radius = vertexClass == VertexClass::Boundary ? 9 : 6;
    painter.drawEllipse(QPointF(16, 16), radius, radius);
  }
  return picture;
}

}  // namespace lodestone
