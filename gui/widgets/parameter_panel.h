// A form made from the field table of an options struct: nothing is written twice.
#pragma once

#include <QFormLayout>
#include <QWidget>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "model/options.h"

namespace lodestone {

/// The form of one table. Not a template itself, so that Qt's meta-object compiler can read it.
class ParameterPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterPanel(QWidget* parent = nullptr);

  /// Adds a row for each field of `Options`, those named in `without` left out.
  template <class Options>
  void addFields(const std::vector<std::string>& without = {}) {
    for (const Field<Options>& field : fields<Options>()) {
      if (std::find(without.begin(), without.end(), field.name) == without.end()) addField(field);
    }
  }
  /// Shows the values; says nothing.
  template <class Options>
  void show(const Options& options) {
    for (const Field<Options>& field : fields<Options>()) setValue(field.name, field.get(options));
  }
  /// The options with what the form says; what nobody touched comes back as it was shown, also where its
  /// editor has too few digits for it; a value that does not pass checkValue() leaves its field as it was.
  template <class Options>
  [[nodiscard]] Options read(Options options) const {
    for (const Field<Options>& field : fields<Options>()) {
      const auto row = rows_.find(field.name);
      if (row == rows_.end()) continue;
      FieldValue value = row->second.value();
      Diagnostics ignored;
      if (checkValue(field, value, ignored)) field.set(options, value);
    }
    return options;
  }
  /// Whether the row of a field is there; it is at first.
  void setRowVisible(const std::string& name, bool visible);
  /// The editor of one field, or null.
  [[nodiscard]] QWidget* editor(const std::string& name) const;

 Q_SIGNALS:
  /// A person changed the named field.
  void edited(const QString& name);

 private:
  struct Row {
    QWidget* editor = nullptr;
    std::function<FieldValue()> get;
    std::function<void(const FieldValue&)> set;
    FieldValue given{};  ///< what was to be shown last
    FieldValue shown{};  ///< what the editor made of it
    [[nodiscard]] FieldValue value() const {
      FieldValue now = get();
      return now == shown ? given : now;
    }
    void take(const FieldValue& value) {
      set(value);
      given = value;
      shown = get();
    }
  };
  void tellEdited(const std::string& name);
  void addField(const FieldInfo& field);
  void setValue(const std::string& name, const FieldValue& value);
  [[nodiscard]] Row makeRow(const FieldInfo& field);
  [[nodiscard]] Row makeFlag(const FieldInfo& field);
  [[nodiscard]] Row makeInteger(const FieldInfo& field);
  [[nodiscard]] Row makeReal(const FieldInfo& field);
  [[nodiscard]] Row makeText(const FieldInfo& field);
  [[nodiscard]] Row makeChoice(const FieldInfo& field);

  QFormLayout* form_;
  std::map<std::string, Row> rows_;
};

/// The help text of a field with its range, for tooltips and What's This.
[[nodiscard]] QString helpText(const FieldInfo& field);

}  // namespace lodestone
