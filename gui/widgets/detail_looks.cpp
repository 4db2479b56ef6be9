#include "gui/widgets/detail_looks.h"

#include <QCoreApplication>

namespace lodestone {
namespace {

QColor toColour(const std::array<float, 3>& colour) {
  return QColor::fromRgbF(colour[0], colour[1], colour[2]);
}

QString translated(const char* text) {
  return QCoreApplication::translate("DetailClass", text);
}

}  // namespace

QString nameOf(DetailClass detailClass) {
  switch (detailClass) {
    case DetailClass::Slight:
      return translated("Slight");
    case DetailClass::Moderate:
      return translated("Moderate");
    case DetailClass::Dramatic:
      return translated("Dramatic");
    case DetailClass::None:
      break;
  }
  return translated("None");
}

QColor colourOf(DetailClass detailClass) {
  return toColour(detailColour(detailClass));
}

QColor colourOfUnseen() {
  return toColour(unseenColour());
}

}  // namespace lodestone
