// The levels on the stage beside the original, and how different they look.
#pragma once

#include <QWidget>

#include "gui/perception/comparing.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace lodestone {

class PictureGrid;

class ComparisonPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ComparisonPanel(Comparing& comparing, QWidget* parent = nullptr);

  [[nodiscard]] PictureGrid& pictures() { return *grid_; }
  [[nodiscard]] QTableWidget& table() { return *table_; }
  [[nodiscard]] QLabel& pooled() { return *pooled_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void makeTable();
  void showPictures();
  void showMeasures();
  void showRow(int row, const QString& name, const QString& help, const LevelMeasures& measures);
  void showState();
  [[nodiscard]] QString readout(const QPoint& pixel) const;

  Comparing& comparing_;
  PictureGrid* grid_;
  QTableWidget* table_;
  QLabel* pooled_;
  QPushButton* stop_;
};

}  // namespace lodestone
