// Why a was chosen: what each value that was tried does to gaps and distances.
#pragma once

#include <QWidget>

#include "gui/simplification/stage.h"

namespace lodestone {

/// The widest gap over the Hausdorff distance, against a, with the chosen value marked. A click takes a
/// value.
class AutoCurve : public QWidget {
  Q_OBJECT

 public:
  explicit AutoCurve(Stage& stage, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  /// Place of a tried value, in the widget.
  [[nodiscard]] QPointF placeOf(const AutoTrial& trial) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] const std::vector<AutoTrial>& trials() const;
  [[nodiscard]] const AutoTrial* trialNear(double x) const;
  [[nodiscard]] QRectF plot() const;
  [[nodiscard]] double highest() const;
  [[nodiscard]] QPointF at(double a, double metres) const;
  void paintAxes(QPainter& painter) const;
  void paintBand(QPainter& painter, const QColor& colour, double (*low)(const AutoTrial&),
                 double (*high)(const AutoTrial&)) const;
  void paintTrials(QPainter& painter) const;

  Stage& stage_;
};

}  // namespace lodestone
