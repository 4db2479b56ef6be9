#include "model/io/footprints/footprint_heights.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace lodestone {
namespace {

constexpr double kFoot = 0.3048;
constexpr double kInch = 0.0254;

// Lower case. Roof tops before eaves: a block stands for the whole building.
constexpr std::array kHeightFields = std::to_array<std::string_view>({
    "height",
    "measuredheight",
    "measured_height",
    "building:height",
    "building_height",
    "buildingheight",
    "bldg_height",
    "bldg_h",
    "bldgheight",
    "height_roof",
    "heightroof",
    "height_m",
    "heightmax",
    "max_height",
    "height_max",
    "hmax",
    "h_max",
    "render_height",
    "est_height",
    "mean_height",
    "avg_height",
    "height_mean",
    "median_height",
    "relh2",
    "hgt",
    "hauteur",
    "hoehe",
    "höhe",
    "altura",
    "h",
    "height_wall",
    "eaveheight",
});
constexpr std::array kFloorFields = std::to_array<std::string_view>({
    "building:levels", "building_levels",    "levels",
    "floors",          "num_floors",         "numfloors",
    "nb_lev",          "nb_levels",          "stories",
    "storeys",         "storeysaboveground", "storeys_above_ground",
    "num_storeys",     "numstories",         "no_floors",
    "floor_count",     "floorcount",         "nb_etages",
    "etages",          "geschosse",          "n_floors",
});

bool equalLetters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

const AttributeValue* findAnyCase(const Attributes& attributes, std::string_view name) {
  if (const AttributeValue* exact = attributes.find(name)) return exact;
  for (const auto& [key, value] : attributes) {
    if (equalLetters(key, name)) return &value;
  }
  return nullptr;
}

std::optional<double> lengthOf(const AttributeValue& value) {
  if (const auto* real = std::get_if<double>(&value))
    return std::isfinite(*real) ? std::optional(*real) : std::nullopt;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* text = std::get_if<std::string>(&value)) return parseLength(*text);
  return std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return text;
}

double metresIn(std::string_view unit) {
  const auto is = [&](std::initializer_list<std::string_view> names) {
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view name) { return equalLetters(unit, name); });
  };
  if (unit.empty() || is({"m", "metres", "meters", "metre", "meter"})) return 1;
  if (is({"ft", "feet", "foot", "'"})) return kFoot;
  if (is({"cm"})) return 0.01;
  if (is({"km"})) return 1000;
  return 0;
}

struct Reading {
  std::optional<double> value;
  bool notPositive = false;
  std::string notUnderstood;  ///< the first field that says something else: height "ca. 12 m"
};

bool isBlank(const AttributeValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text && trimmed(*text).empty();
}

// The first of `names` that is there with a number above zero.
Reading firstOf(const Attributes& attributes, std::span<const std::string_view> names) {
  Reading reading;
  for (const std::string_view name : names) {
    const AttributeValue* value = findAnyCase(attributes, name);
    if (!value || isBlank(*value)) continue;
    const std::optional<double> number = lengthOf(*value);
    if (!number && reading.notUnderstood.empty())
      reading.notUnderstood = fmt::format("{} \"{}\"", name, toText(*value));
    if (!number) continue;
    if (*number > 0) return {number, false, {}};
    reading.notPositive = true;
  }
  return reading;
}

}  // namespace

std::span<const std::string_view> usualHeightFields() {
  return kHeightFields;
}
std::span<const std::string_view> usualFloorFields() {
  return kFloorFields;
}

std::optional<double> parseLength(std::string_view text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_not_of("0123456789.,+-eE"), text.size());
  std::string number(text.substr(0, end));
  std::replace(number.begin(), number.end(), ',', '.');
  const std::optional<double> value = parseNumber(number);
  if (!value) return std::nullopt;
  const std::string_view unit = trimmed(text.substr(end));
  // 5'10" is five feet and ten inches.
  if (unit.size() > 2 && unit.front() == '\'' && unit.back() == '"') {
    const std::optional<double> inches = parseNumber(unit.substr(1, unit.size() - 2));
    return inches ? std::optional(*value * kFoot + *inches * kInch) : std::nullopt;
  }
  const double metres = metresIn(unit);
  return metres > 0 ? std::optional(*value * metres) : std::nullopt;
}

HeightRule::HeightRule(const ImportOptions& options)
    : options_(options), constant_(parseLength(options.height)) {}

std::optional<Diagnostic> HeightRule::whyNot(const ImportOptions& options) {
  const std::optional<double> constant = parseLength(options.height);
  if (!constant || *constant > 0) return std::nullopt;
  return diagnose(Code::OptionOutOfRange, "height is " + options.height + ", wanted above 0 m");
}

bool HeightRule::hasNamedHeight(const Attributes& attributes) const {
  return options_.height.empty() || constant_ || findAnyCase(attributes, options_.height);
}

bool HeightRule::hasNamedFloors(const Attributes& attributes) const {
  return options_.floors.empty() || findAnyCase(attributes, options_.floors);
}

HeightRule::Found HeightRule::find(const Attributes& attributes) const {
  if (constant_) return {*constant_, HeightSource::Constant, false, {}};
  const std::string_view named = options_.height;
  const std::string_view namedFloors = options_.floors;
  const Reading height =
      named.empty() ? firstOf(attributes, kHeightFields) : firstOf(attributes, std::span(&named, 1));
  if (height.value) return {*height.value, HeightSource::Attribute, height.notPositive, {}};
  const Reading floors = namedFloors.empty() ? firstOf(attributes, kFloorFields)
                                             : firstOf(attributes, std::span(&namedFloors, 1));
  if (floors.value) {
    return {*floors.value * options_.floorHeight, HeightSource::Floors, height.notPositive,
            height.notUnderstood};
  }
  return {options_.defaultHeight, HeightSource::Default, height.notPositive || floors.notPositive,
          height.notUnderstood.empty() ? floors.notUnderstood : height.notUnderstood};
}

}  // namespace lodestone
