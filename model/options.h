// One field table for each options struct. The table feeds the command line's flags, the project file, the
// parameter panel, check() and the cache key: an option is written once.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "model/diagnostics.h"

namespace lodestone {

using FieldValue = std::variant<bool, std::int64_t, double, std::string>;
enum class FieldKind { Flag, Integer, Real, Text, Choice };

/// What a person needs to know about one option.
struct FieldInfo {
  std::string name;   ///< as in files and flags: "edge-ratio"
  std::string label;  ///< as in the workbench: "Edge ratio"
  std::string unit;   ///< "m", "px", "°", or empty
  FieldKind kind = FieldKind::Text;
  double min = 0;
  double max = 0;
  std::vector<std::string> choices;  ///< of a Choice
  std::string help;                  ///< one or two sentences; names the paper where there is one
};

template <class Options>
struct Field : FieldInfo {
  std::function<FieldValue(const Options&)> get;
  std::function<void(Options&, const FieldValue&)> set;  ///< \pre the value passed checkValue()
};

/// The table of an options struct; each struct specialises it in the .cpp beside its header.
template <class Options>
const std::vector<Field<Options>>& fields();

/// Options by name, as stored in recipes and project files.
using OptionValues = std::vector<std::pair<std::string, FieldValue>>;

/// Turns `value` into the field's own kind (an integer given for a real, text for a number …) or says why
/// not.
[[nodiscard]] bool checkValue(const FieldInfo& field, FieldValue& value, Diagnostics& diagnostics);
[[nodiscard]] std::string toText(const FieldValue& value);
/// "0.1–1 px"; empty for text and flags.
[[nodiscard]] std::string rangeText(const FieldInfo& field);

// Makers of table rows.
template <class O, class M>
Field<O> fieldOf(FieldInfo info, M O::*member) {
  return {std::move(info), [member](const O& o) { return FieldValue(o.*member); },
          [member](O& o, const FieldValue& v) { o.*member = std::get<M>(v); }};
}
template <class O>
Field<O> flag(bool O::*member, std::string name, std::string label, std::string help) {
  return fieldOf<O>({std::move(name), std::move(label), "", FieldKind::Flag, 0, 1, {}, std::move(help)},
                    member);
}
template <class O>
Field<O> text(std::string O::*member, std::string name, std::string label, std::string help) {
  return fieldOf<O>({std::move(name), std::move(label), "", FieldKind::Text, 0, 0, {}, std::move(help)},
                    member);
}
template <class O>
Field<O> real(double O::*member, std::string name, std::string label, std::string unit, double min,
              double max, std::string help) {
  return fieldOf<O>(
      {std::move(name), std::move(label), std::move(unit), FieldKind::Real, min, max, {}, std::move(help)},
      member);
}
template <class O, class Int>
Field<O> integer(Int O::*member, std::string name, std::string label, std::string unit, double min,
                 double max, std::string help) {
  return {
      {std::move(name), std::move(label), std::move(unit), FieldKind::Integer, min, max, {}, std::move(help)},
      [member](const O& o) { return FieldValue(static_cast<std::int64_t>(o.*member)); },
      [member](O& o, const FieldValue& v) { o.*member = static_cast<Int>(std::get<std::int64_t>(v)); }};
}
/// An enum stored by the position of its name in `choices`.
template <class O, class Enum>
Field<O> choice(Enum O::*member, std::string name, std::string label, std::vector<std::string> choices,
                std::string help) {
  FieldInfo info{std::move(name), std::move(label), "", FieldKind::Choice, 0, 0, choices, std::move(help)};
  return {
      std::move(info),
      [member, choices](const O& o) { return FieldValue(choices.at(static_cast<std::size_t>(o.*member))); },
      [member, choices](O& o, const FieldValue& v) {
        const auto& wanted = std::get<std::string>(v);
        for (std::size_t i = 0; i < choices.size(); ++i) {
          if (choices[i] == wanted) o.*member = static_cast<Enum>(i);
        }
      }};
}

template <class O>
OptionValues values(const O& options) {
  OptionValues result;
  for (const Field<O>& field : fields<O>()) result.emplace_back(field.name, field.get(options));
  return result;
}

/// Sets the named options; unknown names and bad values are said and leave the rest as it was.
template <class O>
Diagnostics setValues(O& options, const OptionValues& given) {
  Diagnostics diagnostics;
  for (auto [name, value] : given) {
    const Field<O>* found = nullptr;
    for (const Field<O>& field : fields<O>()) {
      if (field.name == name) found = &field;
    }
    if (!found) {
      diagnostics.push_back(diagnose(Code::OptionUnknown, name));
    } else if (checkValue(*found, value, diagnostics)) {
      found->set(options, value);
    }
  }
  return diagnostics;
}

/// Errors for every option that is out of its range.
template <class O>
Diagnostics check(const O& options) {
  Diagnostics diagnostics;
  for (const Field<O>& field : fields<O>()) {
    FieldValue value = field.get(options);
    (void)checkValue(field, value, diagnostics);
  }
  return diagnostics;
}

}  // namespace lodestone
