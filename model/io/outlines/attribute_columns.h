// Attributes of buildings as columns of a table, for formats that know rows and columns.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/io/outlines/outline_table.h"

namespace lodestone {

/// One column for each name that the buildings of a city use, in the order of their first use, whole numbers,
/// reals or texts, as their values are. Sources with more names than a table takes (the tags of a large OSM
/// file) keep the most used ones; the others stand together as JSON in a last column, other_attributes.
/// Parts' own attributes are not among them. Cost: linear in the attributes.
class AttributeColumns {
 public:
  /// `taken`: columns that stand there already; a name that is one of these, whatever its case, gets
  /// "_source" behind it.
  AttributeColumns(const CityModel& city, const std::vector<OutlineColumn>& taken);

  [[nodiscard]] const std::vector<OutlineColumn>& columns() const { return columns_; }
  /// Appends a value for each column, none for what is not there. Thread-safe.
  void append(const Attributes& attributes, std::vector<OutlineValue>& row) const;

 private:
  std::vector<OutlineColumn> columns_;
  std::unordered_map<std::string, std::size_t> columnOf_;  ///< by name in the source
  bool others_ = false;
};

}  // namespace lodestone
