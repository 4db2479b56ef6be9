// The contrast sensitivity of the eye, and what it does to the bands of a picture on a display.
#pragma once

#include <QWidget>
#include <vector>

#include "model/perceive_options.h"

namespace lodestone {

/// A(f) over its largest value, and the weights of the five bands of the wavelet transform, straight and
/// diagonal ones, at their frequencies (Du, Zhu and Zhao, Eq. (1)).
class SensitivityPlot : public QWidget {
  Q_OBJECT

 public:
  struct Band {
    int level = 1;  ///< 1: the finest
    bool diagonal = false;
    double frequency = 0;  ///< cycles per degree
    double weight = 0;     ///< 0–1
  };

  explicit SensitivityPlot(QWidget* parent = nullptr);

  void show(const PerceiveOptions& options);
  [[nodiscard]] const std::vector<Band>& bands() const { return bands_; }
  [[nodiscard]] QPointF placeOf(double frequency, double weight) const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QRectF plot() const;
  void paintAxes(QPainter& painter) const;
  void paintCurve(QPainter& painter) const;
  void paintBands(QPainter& painter) const;

  PerceiveOptions options_;
  std::vector<Band> bands_;
};

}  // namespace lodestone
