// Heights of footprints from their attributes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/city_model.h"
#include "model/diagnostics.h"
#include "model/import_options.h"

namespace lodestone {

/// Attribute names that hold the height of a building in metres, the first that is there counts; compared
/// without regard to case. OSM's roof:height is that of the roof alone and is not among them.
[[nodiscard]] std::span<const std::string_view> usualHeightFields();
/// Names that hold the number of floors above ground.
[[nodiscard]] std::span<const std::string_view> usualFloorFields();

/// A length as people write it, in metres: "12", "12,5" (a decimal comma), "12.5 m", "40 ft", "16'",
/// "5'10\"". Nothing for anything else: of "12;14", "10-12" and "ca. 12 m" nobody knows which or how good.
[[nodiscard]] std::optional<double> parseLength(std::string_view text);

/// How one import finds heights: options read once, applied to many buildings. Immutable; thread-safe.
class HeightRule {
 public:
  explicit HeightRule(const ImportOptions& options);
  /// Why a height given for all cannot be one (OptionOutOfRange); nothing where it can.
  [[nodiscard]] static std::optional<Diagnostic> whyNot(const ImportOptions& options);

  /// Height of a building with these attributes, and where it is from. Precedence: constant or named field
  /// (where none is named, the usual ones), floors, default. A height of zero or less is passed over
  /// (`notPositive` is set).
  struct Found {
    double height = 0;
    HeightSource source = HeightSource::Default;
    bool notPositive = false;
    /// A field that would have counted and holds no length, with its value; empty when there is none.
    std::string notUnderstood;
  };
  [[nodiscard]] Found find(const Attributes& attributes) const;
  /// Whether the attributes hold the field named by the user; true when none is named.
  [[nodiscard]] bool hasNamedHeight(const Attributes& attributes) const;
  [[nodiscard]] bool hasNamedFloors(const Attributes& attributes) const;

 private:
  ImportOptions options_;
  std::optional<double> constant_;
};

}  // namespace lodestone
