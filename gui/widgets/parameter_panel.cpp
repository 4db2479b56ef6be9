#include "gui/widgets/parameter_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

namespace lodestone {
namespace {

QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

/// Digits after the point that a range of this size wants.
int decimalsFor(const FieldInfo& field) {
  return field.max - field.min <= 10 ? 3 : field.max <= 1e4 ? 2 : 1;
}

/// Steps in proportion to the value: a range may span many powers of ten.
class RealBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;
  void stepBy(int steps) override {
    const double size = std::max(std::abs(value()) * 0.1, std::pow(10, -decimals()));
    setValue(value() + steps * std::pow(10, std::floor(std::log10(size))));
  }
};

QString suffix(const FieldInfo& field) {
  return field.unit.empty() ? QString() : QStringLiteral(" ") + text(field.unit);
}

}  // namespace

QString helpText(const FieldInfo& field) {
  QString result = QStringLiteral("<p><b>%1</b></p><p>%2</p>")
                       .arg(text(field.label).toHtmlEscaped(), text(field.help).toHtmlEscaped());
  const QString range = text(rangeText(field));
  if (!range.isEmpty()) result += QStringLiteral("<p>%1</p>").arg(range.toHtmlEscaped());
  return result;
}

ParameterPanel::ParameterPanel(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
}

void ParameterPanel::addField(const FieldInfo& field) {
  Row row = makeRow(field);
  const QString help = helpText(field);
  row.editor->setObjectName(text(field.name));
  row.editor->setToolTip(help);
  row.editor->setWhatsThis(help);
  row.editor->setAccessibleName(text(field.label));
  if (field.kind == FieldKind::Flag) {
    form_->addRow(row.editor);
  } else {
    auto* label = new QLabel(text(field.label), this);
    label->setToolTip(help);
    label->setWhatsThis(help);
    label->setBuddy(row.editor);
    form_->addRow(label, row.editor);
  }
  row.given = row.shown = row.get();
  rows_[field.name] = std::move(row);
}

void ParameterPanel::tellEdited(const std::string& name) {
  Row& row = rows_.at(name);
  row.given = row.shown = row.get();
  Q_EMIT edited(text(name));
}

ParameterPanel::Row ParameterPanel::makeRow(const FieldInfo& field) {
  switch (field.kind) {
    case FieldKind::Flag:
      return makeFlag(field);
    case FieldKind::Integer:
      return makeInteger(field);
    case FieldKind::Real:
      return makeReal(field);
    case FieldKind::Choice:
      return makeChoice(field);
    case FieldKind::Text:
      break;
  }
  return makeText(field);
}

ParameterPanel::Row ParameterPanel::makeFlag(const FieldInfo& field) {
  auto* box = new QCheckBox(text(field.label), this);
  connect(box, &QCheckBox::clicked, this, [this, name = field.name] { tellEdited(name); });
  return {box, [box] { return FieldValue(box->isChecked()); },
          [box](const FieldValue& v) { box->setChecked(std::get<bool>(v)); }};
}

ParameterPanel::Row ParameterPanel::makeInteger(const FieldInfo& field) {
  auto* box = new QSpinBox(this);
  box->setRange(static_cast<int>(std::max(field.min, -2e9)), static_cast<int>(std::min(field.max, 2e9)));
  box->setSuffix(suffix(field));
  box->setKeyboardTracking(false);
  connect(box, &QSpinBox::valueChanged, this, [this, name = field.name] { tellEdited(name); });
  return {box, [box] { return FieldValue(std::int64_t{box->value()}); },
          [box](const FieldValue& v) { box->setValue(static_cast<int>(std::get<std::int64_t>(v))); }};
}

ParameterPanel::Row ParameterPanel::makeReal(const FieldInfo& field) {
  auto* box = new RealBox(this);
  box->setDecimals(decimalsFor(field));
  box->setRange(field.min, field.max);
  box->setSuffix(suffix(field));
  box->setKeyboardTracking(false);
  connect(box, &QDoubleSpinBox::valueChanged, this, [this, name = field.name] { tellEdited(name); });
  return {box, [box] { return FieldValue(box->value()); },
          [box](const FieldValue& v) { box->setValue(std::get<double>(v)); }};
}

ParameterPanel::Row ParameterPanel::makeText(const FieldInfo& field) {
  auto* line = new QLineEdit(this);
  connect(line, &QLineEdit::editingFinished, this, [this, line, name = field.name] {
    if (!line->isModified()) return;
    line->setModified(false);
    tellEdited(name);
  });
  return {line, [line] { return FieldValue(line->text().toStdString()); },
          [line](const FieldValue& v) { line->setText(text(std::get<std::string>(v))); }};
}

ParameterPanel::Row ParameterPanel::makeChoice(const FieldInfo& field) {
  auto* box = new QComboBox(this);
  for (const std::string& choice : field.choices) box->addItem(text(choice));
  connect(box, &QComboBox::activated, this, [this, name = field.name] { tellEdited(name); });
  return {box, [box] { return FieldValue(box->currentText().toStdString()); },
          [box](const FieldValue& v) { box->setCurrentText(text(std::get<std::string>(v))); }};
}

void ParameterPanel::setValue(const std::string& name, const FieldValue& value) {
  const auto row = rows_.find(name);
  if (row == rows_.end() || row->second.value() == value) return;
  const QSignalBlocker quiet(row->second.editor);
  row->second.take(value);
}

void ParameterPanel::setRowVisible(const std::string& name, bool visible) {
  const auto row = rows_.find(name);
  if (row != rows_.end()) form_->setRowVisible(row->second.editor, visible);
}

QWidget* ParameterPanel::editor(const std::string& name) const {
  const auto row = rows_.find(name);
  return row == rows_.end() ? nullptr : row->second.editor;
}

}  // namespace lodestone
