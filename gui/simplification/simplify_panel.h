// What is made of the building on the stage: a method, and one that it is compared with.
#pragma once

#include <QWidget>

#include "gui/simplification/stage.h"

class QCheckBox;
class QGroupBox;
class QLabel;
class QPushButton;

namespace lodestone {

class SimplifyForm;

class SimplifyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SimplifyPanel(Stage& stage, QWidget* parent = nullptr);

  [[nodiscard]] SimplifyForm& form(Stage::Method method) { return *forms_[method]; }
  [[nodiscard]] QPushButton& runButton() { return *run_; }
  [[nodiscard]] QPushButton& exportButton() { return *export_; }
  [[nodiscard]] QGroupBox& compareBox() { return *compare_; }

 private:
  QWidget* makeFigures();
  void showState();

  Stage& stage_;
  QLabel* triangles_;
  QLabel* state_;
  QCheckBox* touching_;
  std::array<SimplifyForm*, Stage::MethodCount> forms_{};
  QGroupBox* compare_;
  QPushButton* run_;
  QPushButton* export_;
};

}  // namespace lodestone
