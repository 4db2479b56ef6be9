// Original, method A and method B in figures, beside each other.
#pragma once

#include <QTableWidget>

#include "gui/simplification/stage.h"

namespace lodestone {

class MeasuresPanel : public QTableWidget {
  Q_OBJECT

 public:
  explicit MeasuresPanel(Stage& stage, QWidget* parent = nullptr);
  [[nodiscard]] QSize minimumSizeHint() const override;

 private:
  void showFigures();
  void showLevel(int column, Stage::Method method);
  void set(int row, int column, const QString& text);

  Stage& stage_;
};

}  // namespace lodestone
