// What a layer hands to the next: a value, where there is one, and what there is to say about it.
#pragma once

#include <optional>
#include <utility>

#include "model/diagnostics.h"

namespace lodestone {

/// A value and diagnostics. No value means that the whole operation failed and the diagnostics say why; a
/// value with warnings means that some objects were repaired or left out.
template <class T>
struct Result {
  std::optional<T> value;
  Diagnostics diagnostics;

  Result() = default;
  Result(T v, Diagnostics d = {}) : value(std::move(v)), diagnostics(std::move(d)) {}
  Result(Diagnostic failure) : diagnostics{std::move(failure)} {}
  static Result failure(Diagnostics d) {
    Result result;
    result.diagnostics = std::move(d);
    return result;
  }

  [[nodiscard]] bool ok() const { return value.has_value(); }
  explicit operator bool() const { return ok(); }
  T& operator*() { return *value; }
  const T& operator*() const { return *value; }
  T* operator->() { return &*value; }
  const T* operator->() const { return &*value; }
};

}  // namespace lodestone
