#include "model/io/citygml/citygml_numbers.h"

#include <charconv>
#include <cmath>

namespace lodestone::citygml {
namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/// Reads one number at `at`; null when there is none.
const char* readNumber(const char* at, const char* end, double& value) {
  if (*at == '+' && at + 1 < end) ++at;
  const auto [next, error] = std::from_chars(at, end, value);
  if (error == std::errc::result_out_of_range || error != std::errc() || !std::isfinite(value))
    return nullptr;
  return next;
}

}  // namespace

bool parseNumbers(std::string_view text, std::vector<double>& numbers) {
  const char* at = text.data();
  const char* const end = at + text.size();
  for (;;) {
    while (at < end && isBlank(*at)) ++at;
    if (at == end) return true;
    double value = 0;
    at = readNumber(at, end, value);
    if (!at || (at < end && !isBlank(*at))) return false;
    numbers.push_back(value);
  }
}

int parseCoordinates(std::string_view text, std::vector<double>& numbers) {
  const char* at = text.data();
  const char* const end = at + text.size();
  int tuple = 1;
  bool first = true;
  for (;;) {
    while (at < end && isBlank(*at)) ++at;
    if (at == end) return tuple;
    double value = 0;
    at = readNumber(at, end, value);
    if (!at) return 0;
    numbers.push_back(value);
    if (at < end && *at == ',') {
      ++at;
      if (at == end) return 0;
      if (first) ++tuple;
    } else {
      first = false;
      if (at < end && !isBlank(*at)) return 0;
    }
  }
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace lodestone::citygml
