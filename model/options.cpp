#include "model/options.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "model/attributes.h"

namespace lodestone {
namespace {

bool bad(const FieldInfo& field, const FieldValue& value, Code code, const std::string& wanted,
         Diagnostics& diagnostics) {
  diagnostics.push_back(
      diagnose(code, fmt::format("{} is {}, wanted {}", field.name, toText(value), wanted)));
  return false;
}

std::optional<double> asNumber(const FieldValue& value) {
  if (const auto* d = std::get_if<double>(&value)) return *d;
  if (const auto* i = std::get_if<std::int64_t>(&value)) return static_cast<double>(*i);
  if (const auto* s = std::get_if<std::string>(&value)) return parseNumber(*s);
  return std::nullopt;
}

bool checkNumber(const FieldInfo& field, FieldValue& value, Diagnostics& diagnostics) {
  const std::optional<double> number = asNumber(value);
  if (!number) return bad(field, value, Code::OptionBadValue, "a number", diagnostics);
  if (!(*number >= field.min && *number <= field.max)) {
    return bad(field, value, Code::OptionOutOfRange, rangeText(field), diagnostics);
  }
  if (field.kind == FieldKind::Real) {
    value = *number;
  } else if (*number == std::floor(*number)) {
    value = static_cast<std::int64_t>(*number);
  } else {
    return bad(field, value, Code::OptionBadValue, "a whole number", diagnostics);
  }
  return true;
}

bool checkFlag(const FieldInfo& field, FieldValue& value, Diagnostics& diagnostics) {
  if (std::holds_alternative<bool>(value)) return true;
  const std::string given = toText(value);
  if (given != "true" && given != "false")
    return bad(field, value, Code::OptionBadValue, "true or false", diagnostics);
  value = given == "true";
  return true;
}

}  // namespace

std::string toText(const FieldValue& value) {
  struct Printer {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const { return fmt::format("{}", i); }
    std::string operator()(double d) const { return fmt::format("{}", d); }
    std::string operator()(const std::string& s) const { return s; }
  };
  return std::visit(Printer{}, value);
}

std::string rangeText(const FieldInfo& field) {
  if (field.kind == FieldKind::Choice) return fmt::format("{}", fmt::join(field.choices, ", "));
  if (field.kind != FieldKind::Integer && field.kind != FieldKind::Real) return {};
  return fmt::format("{} to {}{}{}", field.min, field.max, field.unit.empty() ? "" : " ", field.unit);
}

bool checkValue(const FieldInfo& field, FieldValue& value, Diagnostics& diagnostics) {
  switch (field.kind) {
    case FieldKind::Flag:
      return checkFlag(field, value, diagnostics);
    case FieldKind::Integer:
    case FieldKind::Real:
      return checkNumber(field, value, diagnostics);
    case FieldKind::Text:
      value = toText(value);
      return true;
    case FieldKind::Choice:
      break;
  }
  value = toText(value);
  const auto& wanted = std::get<std::string>(value);
  if (std::find(field.choices.begin(), field.choices.end(), wanted) != field.choices.end()) return true;
  return bad(field, value, Code::OptionBadValue, "one of " + rangeText(field), diagnostics);
}

}  // namespace lodestone
