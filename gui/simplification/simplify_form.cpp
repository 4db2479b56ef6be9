#include "gui/simplification/simplify_form.h"

#include <QVBoxLayout>
#include <algorithm>

#include "gui/widgets/field_slider.h"
#include "gui/widgets/parameter_panel.h"

namespace lodestone {
namespace {

/// The paper's cases use a up to 8 (Wang et al. 2021, section 4.2); the box takes more.
constexpr double kUsualA = 10;

const FieldInfo& fieldNamed(const std::string& name) {
  const auto& table = fields<SimplifyOptions>();
  return *std::find_if(table.begin(), table.end(),
                       [&](const FieldInfo& field) { return field.name == name; });
}

}  // namespace

SimplifyForm::SimplifyForm(Stage& stage, Stage::Method method, QWidget* parent)
    : QWidget(parent), stage_(stage), method_(method), form_(new ParameterPanel(this)) {
  form_->addFields<SimplifyOptions>({"rate", "a"});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  rate_ = addSlider("rate", 0, 1, &SimplifyOptions::rate);
  a_ = addSlider("a", 1, kUsualA, &SimplifyOptions::a);
  layout->addWidget(rate_);
  layout->addWidget(a_);
  layout->addWidget(form_);
  connect(form_, &ParameterPanel::edited, this, [this](const QString& name) {
    const QString label = QString::fromStdString(fieldNamed(name.toStdString()).label);
    stage_.setOptions(method_, form_->read(stage_.options(method_)), tr("Change %1").arg(label));
  });
  connect(&stage_, &Stage::optionsChanged, this, &SimplifyForm::show);
  show();
}

FieldSlider* SimplifyForm::addSlider(const std::string& name, double low, double high,
                                     double SimplifyOptions::*member) {
  const FieldInfo& field = fieldNamed(name);
  auto* slider = new FieldSlider(field, {.low = low, .high = high}, this);
  connect(slider, &FieldSlider::edited, this, [this, member, &field](double value) {
    SimplifyOptions options = stage_.options(method_);
    options.*member = value;
    stage_.setOptions(method_, options, tr("Change %1").arg(QString::fromStdString(field.label)));
  });
  return slider;
}

void SimplifyForm::show() {
  const SimplifyOptions& options = stage_.options(method_);
  form_->show(options);
  rate_->setValue(options.rate);
  a_->setValue(options.a);
  const bool topology = needsTopology(options.method);
  a_->setEnabled(topology && !options.aAuto);
  form_->editor("a-auto")->setEnabled(topology);
  for (const char* name : {"stage", "unseen", "error"})
    form_->setRowVisible(name, needsPerception(options.method));
}

}  // namespace lodestone
