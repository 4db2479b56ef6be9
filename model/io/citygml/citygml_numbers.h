// Lists of numbers as GML writes them.
#pragma once

#include <string_view>
#include <vector>

namespace lodestone::citygml {

/// Appends the numbers of a list parted by blanks; false when a piece is no number or not finite (it and what
/// follows are left out). Independent of the locale; no allocation beyond `numbers`.
[[nodiscard]] bool parseNumbers(std::string_view text, std::vector<double>& numbers);

/// Parts GML 2's "x,y,z x,y,z" and appends all numbers. Returns the numbers in the first tuple; 0 when
/// something is no number.
[[nodiscard]] int parseCoordinates(std::string_view text, std::vector<double>& numbers);

[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace lodestone::citygml
