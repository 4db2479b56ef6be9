// Small helpers over simdjson's document tree, for readers inside model/io.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <simdjson.h>

namespace lodestone {

using JsonElement = simdjson::dom::element;
using JsonArray = simdjson::dom::array;
using JsonObject = simdjson::dom::object;

[[nodiscard]] inline std::optional<JsonElement> member(const JsonObject& object, std::string_view key) {
  JsonElement value;
  return object[key].get(value) == simdjson::SUCCESS ? std::optional<JsonElement>(value) : std::nullopt;
}

/// The element as a T (JsonObject, JsonArray, std::string_view, bool); nothing when it is not one.
template <class T>
[[nodiscard]] std::optional<T> as(const std::optional<JsonElement>& element) {
  T value;
  if (!element || element->get(value) != simdjson::SUCCESS) return std::nullopt;
  return value;
}

template <class T>
[[nodiscard]] std::optional<T> memberAs(const JsonObject& object, std::string_view key) {
  return as<T>(member(object, key));
}

/// Any JSON number, integers too.
[[nodiscard]] inline std::optional<double> numberOf(const std::optional<JsonElement>& element) {
  return as<double>(element);
}

/// An integer from 0 to 2³² − 2; nothing for anything else.
[[nodiscard]] inline std::optional<std::uint32_t> indexOf(const std::optional<JsonElement>& element) {
  const auto value = as<std::int64_t>(element);
  if (!value || *value < 0 || *value >= 0xFFFFFFFF) return std::nullopt;
  return static_cast<std::uint32_t>(*value);
}

/// Walks an optional list beside another one: gives nothing once it has ended, or if it never was a list.
class JsonBeside {
 public:
  explicit JsonBeside(const std::optional<JsonElement>& element) {
    const std::optional<JsonArray> array = as<JsonArray>(element);
    if (!array) return;
    at_ = array->begin();
    end_ = array->end();
    listed_ = true;
  }
  std::optional<JsonElement> next() {
    if (!listed_ || !(at_ != end_)) return std::nullopt;
    const JsonElement value = *at_;
    ++at_;
    return value;
  }

 private:
  bool listed_ = false;
  JsonArray::iterator at_;
  JsonArray::iterator end_;
};

}  // namespace lodestone
