#include "algorithms/building_height.h"

#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace lodestone {
namespace {

// CityGML, CityJSON, OpenStreetMap and the cadastres' usual names, the most explicit first.
constexpr std::string_view kHeightFields[] = {"measuredHeight", "height", "building:height",
                                              "HEIGHT_ROOF",    "Height", "HEIGHT"};
constexpr std::string_view kFloorFields[] = {
    "storeysAboveGround", "building:levels", "levels", "floors", "FLOORS", "num_floors"};

/// The first of the named attributes that is a number.
template <class Names>
std::optional<double> firstNumber(const Attributes& attributes, const Names& names) {
  for (const auto& name : names) {
    if (const std::optional<double> value = attributes.number(name)) return value;
  }
  return std::nullopt;
}

struct Found {
  double height;
  HeightSource source;
};

std::optional<Found> heightOf(const Attributes& attributes, const ImportOptions& options) {
  if (const std::optional<double> constant = parseNumber(options.height))
    return Found{*constant, HeightSource::Constant};
  const auto height =
      options.height.empty() ? firstNumber(attributes, kHeightFields) : attributes.number(options.height);
  if (height) return Found{*height, HeightSource::Attribute};
  const auto floors =
      options.floors.empty() ? firstNumber(attributes, kFloorFields) : attributes.number(options.floors);
  if (floors) return Found{*floors * options.floorHeight, HeightSource::Floors};
  return std::nullopt;
}

}  // namespace

void assignHeightFromAttributes(Building& building, const ImportOptions& options, Diagnostics& diagnostics) {
  const std::optional<Found> found = heightOf(building.object.attributes, options);
  if (found && found->height > 0) {
    building.height = found->height;
    building.heightSource = found->source;
    return;
  }
  building.height = options.defaultHeight;
  building.heightSource = HeightSource::Default;
  diagnostics.push_back(
      found ? diagnose(Code::HeightNotPositive, fmt::format("{} m", found->height), building.object.id)
            : diagnose(Code::HeightMissing, {}, building.object.id));
}

}  // namespace lodestone
