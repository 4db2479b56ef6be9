// What clustering takes from a city model beside the footprints.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "algorithms/clustering/clustering.h"
#include "algorithms/clustering/linkages.h"

namespace lodestone {
namespace {

struct Term {
  std::string field;
  double weight = 0;
};

/// "FIELD=WEIGHT"; the last '=' parts them, since names of fields may hold one.
std::optional<Term> parseTerm(const std::string& text) {
  const std::size_t at = text.rfind('=');
  if (at == std::string::npos || at == 0) return std::nullopt;
  const std::optional<double> weight = parseNumber(std::string_view(text).substr(at + 1));
  if (!weight || *weight < 0) return std::nullopt;
  return Term{text.substr(0, at), *weight};
}

/// All values as numbers; nothing when one of them is not a number.
std::optional<std::vector<double>> numbersOf(const CityModel& model, const std::string& field) {
  std::vector<double> values(model.buildings.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t b = 0; b < values.size(); ++b) {
    const Attributes& attributes = model.buildings[b].object.attributes;
    if (attributes.find(field) == nullptr) continue;
    const std::optional<double> number = attributes.number(field);
    if (!number) return std::nullopt;
    values[b] = *number;
  }
  return values;
}

/// Texts numbered in alphabetical order, so that the numbers do not depend on the order of buildings.
std::vector<double> categoriesOf(const CityModel& model, const std::string& field) {
  std::map<std::string, double> numbers;
  for (const Building& building : model.buildings) {
    if (const auto text = building.object.attributes.text(field)) numbers.emplace(*text, 0);
  }
  double next = 0;
  for (auto& [text, number] : numbers) number = next++;
  std::vector<double> values(model.buildings.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t b = 0; b < values.size(); ++b) {
    if (const auto text = model.buildings[b].object.attributes.text(field)) values[b] = numbers.at(*text);
  }
  return values;
}

std::string fieldNames(const CityModel& model) {
  std::set<std::string> names;
  for (const Building& building : model.buildings) {
    for (const auto& [name, value] : building.object.attributes) names.insert(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Fills in the attribute term; false when it cannot be.
bool readAttribute(const CityModel& model, const std::string& text, ClusterContext& context,
                   Diagnostics& diagnostics) {
  const std::optional<Term> term = parseTerm(text);
  if (!term) {
    diagnostics.push_back(
        diagnose(Code::OptionBadValue, fmt::format("attribute \"{}\" is not FIELD=WEIGHT", text)));
    return false;
  }
  context.attributeWeight = term->weight;
  if (std::optional<std::vector<double>> numbers = numbersOf(model, term->field)) {
    context.attribute = std::move(*numbers);
  } else {
    context.attribute = categoriesOf(model, term->field);
    context.attributeIsCategory = true;
  }
  const auto missing = std::count_if(context.attribute.begin(), context.attribute.end(),
                                     [](double value) { return std::isnan(value); });
  if (!context.attribute.empty() && missing == static_cast<std::ptrdiff_t>(context.attribute.size())) {
    diagnostics.push_back(
        diagnose(Code::FieldMissing, fmt::format("{} (there are: {})", term->field, fieldNames(model))));
    return false;
  }
  if (missing > 0) {
    diagnostics.push_back(diagnose(Code::AttributeMissing, fmt::format("{}, on {} of {}", term->field,
                                                                       missing, context.attribute.size())));
  }
  return true;
}

}  // namespace

Result<ClusterContext> clusterContext(const CityModel& model, const ClusterOptions& options,
                                      const std::vector<LineLayer>& barriers) {
  ClusterContext context;
  Diagnostics diagnostics = check(options);
  if (hasErrors(diagnostics)) return Result<ClusterContext>::failure(std::move(diagnostics));
  if (options.linkage == Linkage::Complete && model.buildings.size() > kCompleteLinkLimit) {
    return diagnose(Code::OptionOutOfRange,
                    fmt::format("complete linkage is for at most {} buildings, here are {}",
                                kCompleteLinkLimit, model.buildings.size()));
  }
  for (const LineLayer& layer : barriers) {
    context.barriers.insert(context.barriers.end(), layer.lines.begin(), layer.lines.end());
  }
  if (!options.attribute.empty() && !readAttribute(model, options.attribute, context, diagnostics)) {
    return Result<ClusterContext>::failure(std::move(diagnostics));
  }
  for (const Building& building : model.buildings) {
    if (building.footprint.empty())
      diagnostics.push_back(diagnose(Code::LeafWithoutFootprint, {}, building.object.id));
  }
  if (model.buildings.size() < 2) {
    diagnostics.push_back(diagnose(Code::ClusterTooFew, fmt::format("{}", model.buildings.size())));
  }
  return {std::move(context), std::move(diagnostics)};
}

}  // namespace lodestone
