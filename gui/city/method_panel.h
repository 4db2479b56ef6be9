// The method's parameters, its run button, what is drawn and how many polygons that is.
#pragma once

#include <QWidget>

#include "gui/workspace/workspace.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace lodestone {

class CutForm;
class FieldSlider;
class ParameterPanel;

class MethodPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MethodPanel(Workspace& workspace, QWidget* parent = nullptr);

  [[nodiscard]] QPushButton& runButton() { return *run_; }
  [[nodiscard]] FieldSlider& epsilon();
  [[nodiscard]] FieldSlider& alpha();

 Q_SIGNALS:
  void barriersPresent(bool present);

 private:
  QWidget* makeFigures();
  QWidget* makeRun();
  QWidget* makeClusterGroup();
  void addBarriers();
  void showState();
  void showFigures();
  void showRunButton();

  Workspace& workspace_;
  QLabel* polygons_;
  QLabel* share_;
  CutForm* cut_;
  ParameterPanel* parameters_;
  QListWidget* barriers_;
  QPushButton* run_;
  QLabel* outdated_;
};

}  // namespace lodestone
