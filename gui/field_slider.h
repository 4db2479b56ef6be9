// A slider and a box for one real number, evenly spaced.
#pragma once

#include <QWidget>

#include "model/options.h"

class QDoubleSpinBox;
class QSlider;

namespace lodestone {

class FieldSlider : public QWidget {
  Q_OBJECT

 public:
  /// Slides from `low` to `high`; the box takes the field's whole range.
  FieldSlider(const FieldInfo& field, double low, double high, QWidget* parent = nullptr);

  [[nodiscard]] double value() const;
  /// Shows a value; says nothing.
  void setValue(double value);
  [[nodiscard]] QSlider& slider() { return *slider_; }

 Q_SIGNALS:
  /// A person moved it; told with every step.
  void edited(double value);

 private:
  double low_;
  double high_;
  QSlider* slider_;
  QDoubleSpinBox* box_;
};

}  // namespace lodestone
