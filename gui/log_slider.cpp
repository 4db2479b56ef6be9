#include "gui/log_slider.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/parameter_panel.h"

namespace lodestone {
namespace {
constexpr int kSteps = 1000;
}

LogSlider::LogSlider(const FieldInfo& field, double low, double high, QWidget* parent)
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
  box_->setRange(field.min, field.max);
  box_->setDecimals(1);
  box_->setSuffix(QStringLiteral(" ") + QString::fromStdString(field.unit));
  box_->setKeyboardTracking(false);
  box_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box_->setFixedWidth(fontMetrics().averageCharWidth() * 17);
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
    box_->setValue(valueOf(position));
    Q_EMIT edited(value());
  });
  connect(box_, &QDoubleSpinBox::valueChanged, this, [this](double given) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(positionOf(given));
    Q_EMIT edited(given);
  });
}

double LogSlider::valueOf(int position) const {
  if (position <= 0) return 0;
  return low_ * std::pow(high_ / low_, (position - 1.0) / (kSteps - 1.0));
}

int LogSlider::positionOf(double given) const {
  if (given <= 0) return 0;
  const double share = std::log(std::clamp(given, low_, high_) / low_) / std::log(high_ / low_);
  return 1 + static_cast<int>(std::lround(share * (kSteps - 1)));
}

double LogSlider::value() const {
  return box_->value();
}

void LogSlider::setValue(double given) {
  const QSignalBlocker quietBox(box_);
  const QSignalBlocker quietSlider(slider_);
  if (std::abs(box_->value() - given) > 0.05) box_->setValue(given);
  if (std::abs(valueOf(slider_->value()) - given) > 0.05) slider_->setValue(positionOf(given));
}

}  // namespace lodestone
