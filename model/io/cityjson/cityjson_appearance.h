// Appearance of CityJSON documents.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/city_model.h"
#include "model/diagnostics.h"
#include "model/io/image_path.h"
#include "model/io/json_reading.h"

namespace lodestone {

/// The model's tables of materials and textures, with equal entries once: the features of a CityJSONSeq
/// repeat theirs.
class AppearanceTables {
 public:
  AppearanceTables(CityModel& model, ImagePaths images, Diagnostics& diagnostics)
      : model_(model), images_(std::move(images)), diagnostics_(diagnostics) {}

  /// Index of the entry; −1, and a diagnostic, when it is broken.
  std::int32_t material(const JsonElement& entry);
  std::int32_t texture(const JsonElement& entry);

 private:
  CityModel& model_;
  ImagePaths images_;
  Diagnostics& diagnostics_;
  std::unordered_map<std::string, std::int32_t> knownMaterials_;
  std::unordered_map<std::string, std::int32_t> knownTextures_;
};

/// One document's appearance, by the document's own indices.
struct CityJsonAppearance {
  std::vector<std::int32_t> materials;  ///< indices into the model's table; −1: broken
  std::vector<std::int32_t> textures;
  std::vector<Vec2f> textureVertices;
  std::string materialTheme;  ///< the default ones; may be empty
  std::string textureTheme;
};

[[nodiscard]] CityJsonAppearance readAppearance(const std::optional<JsonElement>& appearance,
                                                AppearanceTables& tables);

/// A geometry's `material` or `texture` by theme: the wanted theme, else the first.
[[nodiscard]] std::optional<JsonObject> themeOf(const std::optional<JsonElement>& byTheme,
                                                const std::string& wanted);

}  // namespace lodestone
