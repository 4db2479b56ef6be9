// A slider and a box for one real number.
#pragma once

#include <QWidget>

#include "model/options.h"

class QDoubleSpinBox;
class QSlider;

namespace lodestone {

/// What the slider's places mean; the box takes the field's whole range.
struct SliderScale {
  double low = 0;
  double high = 1;
  /// Places are powers between low and high (both above 0), with 0 at the left end; else evenly spaced.
  bool byPowers = false;
  int decimals = 3;  ///< of the box

  [[nodiscard]] double valueAt(int place) const;
  [[nodiscard]] int placeOf(double value) const;
  [[nodiscard]] int places() const { return byPowers ? 1000 : 200; }
};

class FieldSlider : public QWidget {
  Q_OBJECT

 public:
  FieldSlider(const FieldInfo& field, const SliderScale& scale, QWidget* parent = nullptr);

  [[nodiscard]] double value() const;
  /// Shows a value; says nothing.
  void setValue(double value);
  [[nodiscard]] QSlider& slider() { return *slider_; }

 Q_SIGNALS:
  /// A person moved it; told with every step.
  void edited(double value);

 private:
  void setUpBox(const FieldInfo& field);

  SliderScale scale_;
  QSlider* slider_;
  QDoubleSpinBox* box_;
};

}  // namespace lodestone
