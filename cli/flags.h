// Command-line flags from the field tables.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "model/options.h"

namespace lodestone::cli {

/// Help text of a field: what it does, its range and its default.
inline std::string helpOf(const FieldInfo& field, const FieldValue& standard) {
  std::string help = field.help;
  const std::string range = rangeText(field);
  const std::string text = toText(standard);
  if (!range.empty()) help += " [" + range + "]";
  if (field.kind != FieldKind::Flag && !text.empty()) help += " (default " + text + ")";
  return help;
}

/// Adds a flag for every field of `options`, which must outlive the parse. Values out of range are usage
/// errors.
template <class O>
void addFlags(CLI::App& app, O& options) {
  for (const Field<O>& field : fields<O>()) {
    const std::string name = "--" + field.name;
    const std::string help = helpOf(field, field.get(options));
    if (field.kind == FieldKind::Flag) {
      app.add_flag_callback(
          name, [&options, &field] { field.set(options, true); }, help);
      continue;
    }
    const auto set = [&options, &field, name](const std::string& given) {
      FieldValue value = given;
      Diagnostics diagnostics;
      if (!checkValue(field, value, diagnostics)) throw CLI::ValidationError(name, diagnostics.front().text);
      field.set(options, value);
    };
    app.add_option_function<std::string>(name, set, help)
        ->type_name(field.unit.empty() ? "VALUE" : field.unit);
  }
}

}  // namespace lodestone::cli
