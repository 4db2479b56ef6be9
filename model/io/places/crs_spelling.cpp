#include "model/io/places/crs_spelling.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <vector>

namespace lodestone {
namespace {

struct NamedCode {
  std::string_view name;
  int code;
};

// Names of the German survey offices (AdV, GeoInfoDok, "Bezeichner der Koordinatenreferenzsysteme").
constexpr std::array kAdvHorizontal = std::to_array<NamedCode>({
    {"ETRS89_UTM31", 25831},     {"ETRS89_UTM32", 25832},          {"ETRS89_UTM33", 25833},
    {"ETRS89_LAT-LON", 4258},    {"ETRS89_LAT-LON-H", 4937},       {"ETRS89_X-Y-Z", 4936},
    {"DE_DHDN_3GK2", 31466},     {"DE_DHDN_3GK3", 31467},          {"DE_DHDN_3GK4", 31468},
    {"DE_DHDN_3GK5", 31469},     {"DE_DHDN_LAT-LON", 4314},        {"DE_PD-83_3GK3", 3396},
    {"DE_PD-83_3GK4", 3397},     {"DE_RD-83_3GK4", 3398},          {"DE_RD-83_3GK5", 3399},
    {"DE_42-83_3GK3", 2397},     {"DE_42-83_3GK4", 2398},          {"DE_42-83_3GK5", 2399},
    {"DE_SOLDNER-BERLIN", 3068}, {"DE_DHDN_SOLDNER-BERLIN", 3068},
});
constexpr std::array kAdvVertical = std::to_array<NamedCode>({
    {"DE_DHHN92_NH", 5783},
    {"DE_DHHN2016_NH", 7837},
    {"DE_DHHN85_NOH", 5784},
    {"DE_DHHN12_NOH", 7699},
    {"DE_SNN76_NH", 5785},
    {"DE_SNN76_NOH", 5785},
});
// Names in use that PROJ does not know, or not by this meaning.
constexpr std::array kNames = std::to_array<NamedCode>({
    {"CH1903", 21781},
    {"CH1903_LV03", 21781},
    {"LV03", 21781},
    {"CH1903+", 2056},
    {"CH1903+_LV95", 2056},
    {"LV95", 2056},
    {"RD", 28992},
    {"RDNEW", 28992},
    {"GK2", 31466},
    {"GK3", 31467},
    {"GK4", 31468},
    {"GK5", 31469},
});

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return std::toupper(c); });
  return result;
}

std::optional<int> wholeNumber(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value <= 0) return std::nullopt;
  return value;
}

template <std::size_t N>
int codeOf(const std::array<NamedCode, N>& table, std::string_view name) {
  const auto* row =
      std::find_if(table.begin(), table.end(), [&](const NamedCode& r) { return r.name == name; });
  return row == table.end() ? 0 : row->code;
}

// Tokens of digits, dots and letters between the separators of URNs and URLs.
std::vector<std::string_view> tokens(std::string_view text) {
  std::vector<std::string_view> result;
  const auto separator = [](char c) {
    return std::string_view(":/,+?&=# \t\r\n").find(c) != std::string_view::npos;
  };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && !separator(text[end])) ++end;
    if (end > i) result.push_back(text.substr(i, end - i));
    i = end + 1;
  }
  return result;
}

// The first number of four or more digits after each "EPSG", so that versions ("6.12", "0") before the code
// do no harm; a second such number is a second code: "EPSG:25832+5783".
std::vector<int> epsgCodes(std::string_view text) {
  constexpr int kLowestCode = 1024;
  std::vector<int> codes;
  bool open = false;
  for (const std::string_view token : tokens(text)) {
    if (token.starts_with("EPSG")) {
      open = true;
    } else if (token == "CRS" || token == "URN" || token.starts_with("HTTP")) {
      open = false;
    } else if (const std::optional<int> number = wholeNumber(token);
               open && number && *number >= kLowestCode) {
      codes.push_back(*number);
    }
  }
  return codes;
}

bool isAdv(std::string_view upperCase) {
  return upperCase.find("ADV:CRS:") != std::string_view::npos || upperCase.starts_with("ETRS89_") ||
         upperCase.starts_with("DE_");
}

CrsSpelling fromAdv(std::string_view upperCase, CrsSpelling result) {
  const std::size_t colon = upperCase.find_last_of(':');
  std::string_view rest = colon == std::string_view::npos ? upperCase : upperCase.substr(colon + 1);
  while (!rest.empty()) {
    const std::size_t star = rest.find('*');
    const std::string_view part = rest.substr(0, star);
    if (result.horizontal == 0) result.horizontal = codeOf(kAdvHorizontal, part);
    if (result.vertical == 0) result.vertical = codeOf(kAdvVertical, part);
    rest = star == std::string_view::npos ? std::string_view() : rest.substr(star + 1);
  }
  if (result.horizontal != 0) result.kind = CrsSpelling::Kind::Epsg;
  return result;
}

// WKT and PROJ strings hold codes of their parts; they must not be mistaken for a code of the whole.
bool isDefinition(std::string_view text) {
  return text.find('[') != std::string_view::npos || text.find("+proj") != std::string_view::npos ||
         text.starts_with('{');
}

}  // namespace

CrsSpelling parseCrs(std::string_view spelling) {
  CrsSpelling result;
  result.text = std::string(trimmed(spelling));
  if (result.text.empty()) return result;
  result.kind = result.text.front() == '#' ? CrsSpelling::Kind::Local : CrsSpelling::Kind::Text;
  if (result.kind == CrsSpelling::Kind::Local || isDefinition(result.text)) return result;

  const std::string name = upper(result.text);
  if (name.find("CRS84") != std::string::npos || name == "CRS:84") {
    result.kind = CrsSpelling::Kind::Epsg;
    result.horizontal = 4326;
    result.eastFirst = true;
    return result;
  }
  if (isAdv(name)) return fromAdv(name, result);
  std::vector<int> codes = epsgCodes(name);
  if (const std::optional<int> bare = wholeNumber(name)) codes = {*bare};
  if (const int known = codeOf(kNames, name); known != 0) codes = {known};
  if (codes.empty()) return result;
  result.kind = CrsSpelling::Kind::Epsg;
  result.horizontal = codes[0];
  result.vertical = codes.size() > 1 ? codes[1] : 0;
  result.eastFirst = name.starts_with("EPSG:");
  return result;
}

}  // namespace lodestone
