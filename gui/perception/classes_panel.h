// Where classes of detail are cut, and how many triangles each stage may touch by that.
#pragma once

#include <QWidget>

#include "gui/perception/perceiving.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace lodestone {

class DifferencePlot;

class ClassesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ClassesPanel(Perceiving& perceiving, QWidget* parent = nullptr);

  [[nodiscard]] DifferencePlot& plot() { return *plot_; }
  [[nodiscard]] QTableWidget& stages() { return *stages_; }

 private:
  void makeTable();
  void setCut(std::size_t cut, double greyLevels, const QString& what);
  void findAgain();
  void useStage();
  void showPlot();
  void showStages();
  void showUse();
  [[nodiscard]] QStringList removedLines(Stage::Method method) const;

  Perceiving& perceiving_;
  DifferencePlot* plot_;
  QTableWidget* stages_;
  QLabel* removed_;
  QPushButton* find_;
  QPushButton* use_;
};

}  // namespace lodestone
