#include "model/io/cityjson/cityjson_appearance.h"

#include <cmath>
#include <limits>

#include "model/io/json_writing.h"

namespace lodestone {
namespace {

bool readColour(const JsonElement& element, std::array<float, 3>& colour) {
  JsonBeside values{element};
  std::array<float, 3> read{};
  for (float& channel : read) {
    const auto number = numberOf(values.next());
    if (!number || !std::isfinite(*number)) return false;
    channel = static_cast<float>(*number);
  }
  colour = read;
  return true;
}

/// Fields that Material has no place for, as a JSON object; empty when there are none.
std::string otherFields(const JsonObject& entry) {
  std::string json;
  for (const auto& [key, value] : entry) {
    if (key == "name" || key == "diffuseColor" || key == "transparency") continue;
    json += json.empty() ? "{" : ",";
    json += jsonQuoted(key) + ":" + simdjson::minify(value);
  }
  return json.empty() ? json : json + "}";
}

}  // namespace

std::int32_t AppearanceTables::material(const JsonElement& element) {
  const auto [known, isNew] = knownMaterials_.try_emplace(simdjson::minify(element), -1);
  if (!isNew) return known->second;
  const auto entry = as<JsonObject>(element);
  if (!entry) {
    diagnostics_.push_back(diagnose(Code::AppearanceBad, "a material is not an object"));
    return -1;
  }
  Material material;
  material.name = memberAs<std::string_view>(*entry, "name").value_or("");
  const auto colour = member(*entry, "diffuseColor");
  if (colour && !readColour(*colour, material.diffuse)) {
    diagnostics_.push_back(diagnose(Code::AppearanceBad, "diffuseColor of material " + material.name));
  }
  material.transparency = static_cast<float>(numberOf(member(*entry, "transparency")).value_or(0));
  material.json = otherFields(*entry);
  model_.materials.push_back(std::move(material));
  return known->second = static_cast<std::int32_t>(model_.materials.size()) - 1;
}

std::int32_t AppearanceTables::texture(const JsonElement& element) {
  const auto [known, isNew] = knownTextures_.try_emplace(simdjson::minify(element), -1);
  if (!isNew) return known->second;
  const auto entry = as<JsonObject>(element);
  const auto image = entry ? memberAs<std::string_view>(*entry, "image") : std::nullopt;
  if (!image) {
    diagnostics_.push_back(diagnose(Code::AppearanceBad, "a texture names no image"));
    return -1;
  }
  Texture texture = images_.find(*image, diagnostics_);
  texture.wrap = memberAs<std::string_view>(*entry, "wrapMode").value_or("");
  texture.type = memberAs<std::string_view>(*entry, "textureType").value_or("");
  model_.textures.push_back(std::move(texture));
  return known->second = static_cast<std::int32_t>(model_.textures.size()) - 1;
}

CityJsonAppearance readAppearance(const std::optional<JsonElement>& element, AppearanceTables& tables) {
  CityJsonAppearance result;
  const auto appearance = as<JsonObject>(element);
  if (!appearance) return result;
  JsonBeside materials(member(*appearance, "materials"));
  while (const auto entry = materials.next()) result.materials.push_back(tables.material(*entry));
  JsonBeside textures(member(*appearance, "textures"));
  while (const auto entry = textures.next()) result.textures.push_back(tables.texture(*entry));
  JsonBeside vertices(member(*appearance, "vertices-texture"));
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  while (const auto vertex = vertices.next()) {
    JsonBeside uv(*vertex);
    const double u = numberOf(uv.next()).value_or(kNone);
    const double v = numberOf(uv.next()).value_or(kNone);
    result.textureVertices.emplace_back(static_cast<float>(u), static_cast<float>(v));
  }
  result.materialTheme = memberAs<std::string_view>(*appearance, "default-theme-material").value_or("");
  result.textureTheme = memberAs<std::string_view>(*appearance, "default-theme-texture").value_or("");
  return result;
}

std::optional<JsonObject> themeOf(const std::optional<JsonElement>& byTheme, const std::string& wanted) {
  const auto themes = as<JsonObject>(byTheme);
  if (!themes) return std::nullopt;
  if (const auto theme = memberAs<JsonObject>(*themes, wanted)) return theme;
  for (const auto& [name, theme] : *themes) return as<JsonObject>(JsonElement(theme));
  return std::nullopt;
}

}  // namespace lodestone
