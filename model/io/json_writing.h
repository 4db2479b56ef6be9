// Pieces of JSON text, for writers that stream.
#pragma once

#include <string>
#include <string_view>

#include "model/attributes.h"

namespace lodestone {

/// The text in quotes with everything escaped that must be. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string jsonQuoted(std::string_view text);
/// A finite number as a JSON number that reads back as the same double and as a double ("5.0"); "null"
/// otherwise.
[[nodiscard]] std::string jsonNumber(double value);
/// A value as JSON; structured ones as the source had them.
[[nodiscard]] std::string attributeJson(const AttributeValue& value);

}  // namespace lodestone
