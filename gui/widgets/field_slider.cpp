#include "gui/widgets/field_slider.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/widgets/parameter_panel.h"

namespace lodestone {

double SliderScale::valueAt(int place) const {
  if (!byPowers) return low + (high - low) * place / places();
  return place <= 0 ? 0 : low * std::pow(high / low, (place - 1.0) / (places() - 1.0));
}

int SliderScale::placeOf(double value) const {
  if (!byPowers) return static_cast<int>(std::lround((value - low) / (high - low) * places()));
  if (value <= 0) return 0;
  const double share = std::log(std::clamp(value, low, high) / low) / std::log(high / low);
  return 1 + static_cast<int>(std::lround(share * (places() - 1)));
}

FieldSlider::FieldSlider(const FieldInfo& field, const SliderScale& scale, QWidget* parent)
    : QWidget(parent),
      scale_(scale),
      slider_(new QSlider(Qt::Horizontal, this)),
      box_(new QDoubleSpinBox(this)) {
  auto* label = new QLabel(QString::fromStdString(field.label), this);
  label->setBuddy(box_);
  slider_->setObjectName(QString::fromStdString(field.name) + QStringLiteral("Slider"));
  slider_->setRange(0, scale_.places());
  slider_->setPageStep(scale_.places() / 20);
  slider_->setAccessibleName(label->text());
  setUpBox(field);
  const QString help = helpText(field);
  setToolTip(help);
  setWhatsThis(help);

  auto* top = new QHBoxLayout;
  top->addWidget(label, 1);
  top->addWidget(box_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(top);
  layout->addWidget(slider_);

  connect(slider_, &QSlider::valueChanged, this, [this](int place) {
    const QSignalBlocker quiet(box_);
    box_->setValue(scale_.valueAt(place));
    Q_EMIT edited(value());
  });
  connect(box_, &QDoubleSpinBox::valueChanged, this, [this](double given) {
    setValue(given);
    Q_EMIT edited(given);
  });
}

void FieldSlider::setUpBox(const FieldInfo& field) {
  box_->setObjectName(QString::fromStdString(field.name));
  box_->setDecimals(scale_.decimals);
  box_->setRange(field.min, field.max);
  box_->setSingleStep((scale_.high - scale_.low) / 20);
  if (!field.unit.empty()) box_->setSuffix(QStringLiteral(" ") + QString::fromStdString(field.unit));
  box_->setKeyboardTracking(false);
  if (!scale_.byPowers) return;
  box_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box_->setFixedWidth(fontMetrics().averageCharWidth() * 17);
}

double FieldSlider::value() const {
  return box_->value();
}

void FieldSlider::setValue(double given) {
  const QSignalBlocker quietBox(box_);
  const QSignalBlocker quietSlider(slider_);
  const double half = 0.5 * std::pow(10, -scale_.decimals);  // less than the box shows
  if (std::abs(box_->value() - given) > half) box_->setValue(given);
  if (std::abs(scale_.valueAt(slider_->value()) - given) > half) slider_->setValue(scale_.placeOf(given));
}

}  // namespace lodestone
