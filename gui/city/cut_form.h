// What is drawn: the two live sliders, and whether the camera chooses.
#pragma once

#include <QGroupBox>

#include "gui/workspace/workspace.h"

class QLabel;
class QToolButton;

namespace lodestone {

class FieldSlider;

class CutForm : public QGroupBox {
  Q_OBJECT

 public:
  explicit CutForm(Workspace& workspace, QWidget* parent = nullptr);

  [[nodiscard]] FieldSlider& epsilon() { return *epsilon_; }
  [[nodiscard]] FieldSlider& alpha() { return *alpha_; }

 private:
  FieldSlider* makeSlider(const char* name, double CutOptions::*option, double low, double high);
  QToolButton* makeButton(const QString& name, const QString& text, const QString& iconName);
  QWidget* makeSource();
  void showState();
  /// Says what chose the nodes that are drawn, and how to choose otherwise.
  void showSource();

  Workspace& workspace_;
  FieldSlider* epsilon_;
  FieldSlider* alpha_;
  QLabel* sign_;
  QLabel* source_;
  QToolButton* follow_;
  QToolButton* freeze_;
};

}  // namespace lodestone
