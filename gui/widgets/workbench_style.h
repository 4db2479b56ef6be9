// Qt's Fusion style, with check boxes and chosen tool buttons that can be seen on dark.
#pragma once

#include <QProxyStyle>

namespace lodestone {

/// Fusion outlines a box with a darker shade of the window, which is nothing on a dark one. Here the outline
/// lies between base and text, at a contrast of 3:1 or more with the base. A tool button that is on is
/// tinted. Buttons of dialogs have words alone: the stock icons are not ours.
class WorkbenchStyle : public QProxyStyle {
  Q_OBJECT

 public:
  WorkbenchStyle();
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget = nullptr) const override;
  int styleHint(StyleHint hint, const QStyleOption* option = nullptr, const QWidget* widget = nullptr,
                QStyleHintReturn* returned = nullptr) const override;
};

}  // namespace lodestone
