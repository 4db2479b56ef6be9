// Attributes of city objects: named values in the order of their source.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lodestone {

/// A structured value (list or object) kept as JSON text, so that nothing a source says is lost.
struct JsonText {
  std::string text;
  bool operator==(const JsonText&) const = default;
};

using AttributeValue = std::variant<bool, std::int64_t, double, std::string, JsonText>;

class Attributes {
 public:
  using Entry = std::pair<std::string, AttributeValue>;

  /// Sets or replaces a value; the order of first insertion is kept.
  void set(std::string_view name, AttributeValue value);
  [[nodiscard]] const AttributeValue* find(std::string_view name) const;
  /// The value as a number: numbers, and text that is a number in full ("12.5"); units are not understood.
  [[nodiscard]] std::optional<double> number(std::string_view name) const;
  /// The value as text, as it would be printed.
  [[nodiscard]] std::optional<std::string> text(std::string_view name) const;

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] auto begin() const { return entries_.begin(); }
  [[nodiscard]] auto end() const { return entries_.end(); }
  bool operator==(const Attributes&) const = default;

 private:
  std::vector<Entry> entries_;
};

[[nodiscard]] std::string toText(const AttributeValue& value);
/// A number written in full in `text` (locale-independent), else nothing. Never NaN or infinite.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

}  // namespace lodestone
