// A slider and a box for one real number over many powers of ten.
#pragma once

#include <QWidget>

#include "model/options.h"

class QDoubleSpinBox;
class QSlider;

namespace lodestone {

class LogSlider : public QWidget {
  Q_OBJECT

 public:
  /// Slides from `low` to `high` (both above 0) by powers, with 0 at the left end; the box takes the field's
  /// whole range.
  LogSlider(const FieldInfo& field, double low, double high, QWidget* parent = nullptr);

  [[nodiscard]] double value() const;
  /// Shows a value; says nothing.
  void setValue(double value);
  [[nodiscard]] QSlider& slider() { return *slider_; }

 Q_SIGNALS:
  /// A person moved it; told with every step.
  void edited(double value);

 private:
  [[nodiscard]] double valueOf(int position) const;
  [[nodiscard]] int positionOf(double value) const;

  double low_;
  double high_;
  QSlider* slider_;
  QDoubleSpinBox* box_;
};

}  // namespace lodestone
