// The property table of a GLB (EXT_structural_metadata): what each feature is, and which buildings it stands
// for.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/lod_chain.h"

namespace lodestone {

/// Attributes of the buildings that become columns: the (at most 64) commonest that at least one building in
/// a hundred has, as numbers where every value is one.
struct AttributeColumn {
  std::string name;      ///< as the source spells it
  std::string property;  ///< as a property id: letters, digits and underscores
  bool isNumber = false;
};
[[nodiscard]] std::vector<AttributeColumn> attributeColumns(const CityModel& city);

/// Columns that grow row by row, in the order of the level's objects.
class GlbTable {
 public:
  GlbTable(std::shared_ptr<const CityModel> city, std::size_t level);

  void add(const LevelObject& object);
  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// The extension's object; `addView(bytes)` stores a buffer view and returns its index. \pre rows() > 0
  [[nodiscard]] nlohmann::ordered_json write(
      const std::function<std::size_t(std::string_view)>& addView) const;

 private:
  /// Texts one after the other and where each begins (and the last ends).
  struct Texts {
    std::string bytes;
    std::vector<std::uint32_t> offsets{0};
    void add(std::string_view text);
  };
  struct Column {
    AttributeColumn attribute;
    std::vector<double> numbers;
    Texts texts;
  };

  std::shared_ptr<const CityModel> city_;
  std::size_t level_;
  std::size_t rows_ = 0;
  Texts ids_;
  std::vector<std::uint8_t> roles_;
  std::vector<std::uint32_t> nodes_;
  std::vector<std::uint32_t> of_;
  Texts buildings_;
  std::vector<std::uint32_t> buildingOffsets_{0};
  std::vector<double> bases_;
  std::vector<double> heights_;
  std::vector<double> negatives_;
  std::vector<Column> columns_;
};

}  // namespace lodestone
