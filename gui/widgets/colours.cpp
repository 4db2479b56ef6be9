#include "gui/widgets/colours.h"

#include <QApplication>

#include "gui/view3d/palette.h"

namespace lodestone {

QColor mixed(const QColor& a, const QColor& b, double share) {
  return QColor::fromRgbF(static_cast<float>(a.redF() * (1 - share) + b.redF() * share),
                          static_cast<float>(a.greenF() * (1 - share) + b.greenF() * share),
                          static_cast<float>(a.blueF() * (1 - share) + b.blueF() * share));
}

namespace {

QPalette makePalette(const QColor& window, const QColor& base, const QColor& text, const QColor& accent) {
  const bool dark = window.lightness() < 128;
  QPalette palette(window);
  const QColor button = dark ? window.lighter(125) : window.darker(102);
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, dark ? base.lighter(115) : base.darker(103));
  palette.setColor(QPalette::Button, button);
  palette.setColor(QPalette::ToolTipBase, dark ? window.lighter(140) : QColor(0xff, 0xff, 0xf4));
  palette.setColor(QPalette::Link, accent);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, dark ? QColor(0x10, 0x16, 0x1a) : QColor(Qt::white));
  QColor faint = text;
  faint.setAlphaF(0.55F);
  palette.setColor(QPalette::PlaceholderText, faint);
  for (const auto role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, text);
    palette.setColor(QPalette::Disabled, role, mixed(text, window, 0.6));
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, mixed(text, window, 0.75));  // grooves of sliders
  return palette;
}

}  // namespace

QColor selectionColour() {
  return {0xe6, 0x9f, 0x00};
}
QColor cutLineColour() {
  return {0xc4, 0x4e, 0x2c};
}

QColor clusterColour(NodeId node, const QPalette& palette) {
  if (node == kNoNode) return palette.color(QPalette::Text);
  const Rgb colour = clusterColour(node);
  return QColor::fromRgbF(colour[0], colour[1], colour[2]);
}

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128;
}

QPalette paletteOf(Appearance appearance) {
  static const QPalette system = QApplication::palette();
  if (appearance == Appearance::Dark) {
    return makePalette(QColor(0x25, 0x2b, 0x30), QColor(0x1c, 0x21, 0x25), QColor(0xe4, 0xe9, 0xec),
                       QColor(0x4f, 0xb3, 0xbf));
  }
  if (appearance == Appearance::Light) {
    return makePalette(QColor(0xf3, 0xf5, 0xf6), QColor(Qt::white), QColor(0x1e, 0x27, 0x2e),
                       QColor(0x1b, 0x7f, 0x8c));
  }
  return system;
}

}  // namespace lodestone
