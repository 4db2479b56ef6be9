// The options of one method of the stage, made from their field table.
#pragma once

#include <QWidget>

#include "gui/simplification/stage.h"

namespace lodestone {

class FieldSlider;
class ParameterPanel;

class SimplifyForm : public QWidget {
  Q_OBJECT

 public:
  SimplifyForm(Stage& stage, Stage::Method method, QWidget* parent = nullptr);

  [[nodiscard]] FieldSlider& rate() { return *rate_; }
  [[nodiscard]] FieldSlider& a() { return *a_; }
  [[nodiscard]] ParameterPanel& fields() { return *form_; }

 private:
  FieldSlider* addSlider(const std::string& name, double low, double high, double SimplifyOptions::*member);
  void show();

  Stage& stage_;
  Stage::Method method_;
  ParameterPanel* form_;
  FieldSlider* rate_;
  FieldSlider* a_;
};

}  // namespace lodestone
