#include "model/io/outlines/attribute_columns.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "model/io/json_writing.h"

namespace lodestone {
namespace {

using Type = OutlineColumn::Type;

constexpr std::size_t kMostColumns = 500;  // SQLite takes 2000, and a person reads fewer

struct Use {
  std::string name;
  std::size_t count = 0;
  Type type = Type::Integer;  ///< the narrowest that holds all values
};

Type typeOf(const AttributeValue& value) {
  if (std::holds_alternative<std::int64_t>(value)) return Type::Integer;
  return std::holds_alternative<double>(value) ? Type::Real : Type::Text;
}

std::vector<Use> usesIn(const CityModel& city) {
  std::vector<Use> uses;
  std::unordered_map<std::string, std::size_t> known;
  for (const Building& building : city.buildings) {
    for (const auto& [name, value] : building.object.attributes) {
      const auto [found, added] = known.try_emplace(name, uses.size());
      if (added) uses.push_back({name, 0, Type::Integer});
      Use& use = uses[found->second];
      ++use.count;
      use.type = std::max(use.type, typeOf(value));
    }
  }
  return uses;
}

void keepMostUsed(std::vector<Use>& uses) {
  std::stable_sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.count > b.count; });
  uses.resize(kMostColumns);
}

/// Names that differ in case alone are one to SQLite; two names are its own.
class Names {
 public:
  explicit Names(const std::vector<OutlineColumn>& taken) : used_{"fid", "geom", "other_attributes"} {
    for (const OutlineColumn& column : taken) used_.insert(lower(column.name));
  }
  std::string unique(const std::string& name) {
    std::string result = name.empty() ? "unnamed" : name;
    if (used_.contains(lower(result))) result += "_source";
    const std::string base = result;
    for (int i = 2; !used_.insert(lower(result)).second; ++i) result = base + "_" + std::to_string(i);
    return result;
  }

 private:
  static std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
  }
  std::set<std::string> used_;
};

OutlineValue valueFor(const AttributeValue& value, Type type) {
  if (type == Type::Text) return toText(value);
  if (const auto* whole = std::get_if<std::int64_t>(&value))
    return type == Type::Integer ? OutlineValue(*whole) : OutlineValue(static_cast<double>(*whole));
  return std::get<double>(value);
}

}  // namespace

AttributeColumns::AttributeColumns(const CityModel& city, const std::vector<OutlineColumn>& taken) {
  std::vector<Use> uses = usesIn(city);
  others_ = uses.size() > kMostColumns;
  if (others_) keepMostUsed(uses);
  Names names(taken);
  for (const Use& use : uses) {
    columnOf_.emplace(use.name, columns_.size());
    columns_.push_back({names.unique(use.name), use.type, true});
  }
  if (others_) columns_.push_back({"other_attributes", Type::Text, true});
}

void AttributeColumns::append(const Attributes& attributes, std::vector<OutlineValue>& row) const {
  const std::size_t first = row.size();
  row.resize(first + columns_.size());
  std::string others;
  for (const auto& [name, value] : attributes) {
    const auto found = columnOf_.find(name);
    if (found != columnOf_.end()) {
      row[first + found->second] = valueFor(value, columns_[found->second].type);
    } else {
      others += (others.empty() ? "" : ",") + jsonQuoted(name) + ":" + attributeJson(value);
    }
  }
  if (!others.empty()) row.back() = "{" + others + "}";
}

}  // namespace lodestone
