#include "gui/field_slider.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "gui/parameter_panel.h"

namespace lodestone {
namespace {

constexpr int kSteps = 200;

}  // namespace

FieldSlider::FieldSlider(const FieldInfo& field, double low, double high, QWidget* parent)
    : QWidget(parent),
      low_(low),
      high_(high),
      slider_(new QSlider(Qt::Horizontal, this)),
      box_(new QDoubleSpinBox(this)) {
  const QString help = helpText(field);
  auto* label = new QLabel(QString::fromStdString(field.label), this);
  label->setBuddy(box_);
  slider_->setObjectName(QString::fromStdString(field.name) + QStringLiteral("Slider"));
  slider_->setRange(0, kSteps);
  slider_->setPageStep(kSteps / 20);
  slider_->setAccessibleName(label->text());
  box_->setObjectName(QString::fromStdString(field.name));
  box_->setDecimals(3);
  box_->setRange(field.min, field.max);
  box_->setSingleStep((high - low) / 20);
  if (!field.unit.empty()) box_->setSuffix(QStringLiteral(" ") + QString::fromStdString(field.unit));
  box_->setKeyboardTracking(false);
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

  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    const QSignalBlocker quiet(box_);
    box_->setValue(low_ + (high_ - low_) * position / kSteps);
    Q_EMIT edited(value());
  });
  connect(box_, &QDoubleSpinBox::valueChanged, this, [this](double given) {
    setValue(given);
    Q_EMIT edited(given);
  });
}

double FieldSlider::value() const {
  return box_->value();
}

void FieldSlider::setValue(double given) {
  const QSignalBlocker quietBox(box_);
  const QSignalBlocker quietSlider(slider_);
  if (std::abs(box_->value() - given) > 5e-4) box_->setValue(given);
  slider_->setValue(static_cast<int>(std::lround((given - low_) / (high_ - low_) * kSteps)));
}

}  // namespace lodestone
