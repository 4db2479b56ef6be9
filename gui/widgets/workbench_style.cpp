#include "gui/widgets/workbench_style.h"

#include <QStyleOptionButton>

#include "gui/widgets/colours.h"

namespace lodestone {

WorkbenchStyle::WorkbenchStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void WorkbenchStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                   const QWidget* widget) const {
  if (element == PE_PanelButtonTool && option->state.testFlag(State_On)) {
    QStyleOption chosen(*option);
    const QColor plain = chosen.palette.color(QPalette::Button);
    chosen.palette.setColor(QPalette::Button, mixed(plain, chosen.palette.color(QPalette::Highlight), 0.4));
    QProxyStyle::drawPrimitive(element, &chosen, painter, widget);
    return;
  }
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
  if (!button || (element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton)) {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    return;
  }
  QStyleOptionButton visible(*button);
  const QColor base = visible.palette.color(QPalette::Base);
  const QColor text = visible.palette.color(QPalette::Text);
  visible.palette.setColor(QPalette::Window, mixed(base, text, 0.6));  // Fusion takes the outline from it
  QProxyStyle::drawPrimitive(element, &visible, painter, widget);
}

int WorkbenchStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                              QStyleHintReturn* returned) const {
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
  return QProxyStyle::styleHint(hint, option, widget, returned);
}

}  // namespace lodestone
