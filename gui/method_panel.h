// The method's parameters, its run button, and the two live sliders.
#pragma once

#include <QWidget>

#include "gui/workspace.h"

class QLabel;
class QListWidget;
class QPushButton;
class QToolButton;

namespace lodestone {

class FieldSlider;
class ParameterPanel;

class MethodPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MethodPanel(Workspace& workspace, QWidget* parent = nullptr);

  [[nodiscard]] QPushButton& runButton() { return *run_; }
  [[nodiscard]] FieldSlider& epsilon() { return *epsilon_; }
  [[nodiscard]] FieldSlider& alpha() { return *alpha_; }

 Q_SIGNALS:
  void barriersPresent(bool present);

 private:
  QWidget* makeFigures();
  QWidget* makeRun();
  QWidget* makeCutGroup();
  QWidget* makeClusterGroup();
  void addBarriers();
  void showState();
  void showFigures();
  void showRunButton();

  Workspace& workspace_;
  QLabel* polygons_;
  QLabel* share_;
  QLabel* source_;
  FieldSlider* epsilon_;
  FieldSlider* alpha_;
  QToolButton* freeze_;
  QToolButton* follow_;
  ParameterPanel* parameters_;
  QListWidget* barriers_;
  QPushButton* run_;
  QLabel* outdated_;
};

}  // namespace lodestone
