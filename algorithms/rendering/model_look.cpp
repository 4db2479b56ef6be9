#include "algorithms/rendering/model_look.h"

#include <algorithm>
#include <exception>
#include <set>

#include "algorithms/rendering/rendering.h"
#include "algorithms/rendering/texture_sampling.h"
#include "model/io/texture_image.h"

namespace lodestone {
namespace {

/// Larger images are no use in pictures of a whole building.
constexpr int kMostTexels = 4096;

TexturePyramid::Level fromTheBottom(const Picture& picture) {
  TexturePyramid::Level level{picture.width, picture.height, {}};
  const std::size_t row = 4 * static_cast<std::size_t>(picture.width);
  level.rgba.reserve(picture.rgba.size());
  for (std::size_t end = picture.rgba.size(); end > 0; end -= row)
    level.rgba.insert(level.rgba.end(), picture.rgba.begin() + static_cast<std::ptrdiff_t>(end - row),
                      picture.rgba.begin() + static_cast<std::ptrdiff_t>(end));
  return level;
}

/// CityGML's "none" and "border" show a colour beyond the image; its border does as well.
TextureWrap wrapOf(const Texture& texture) {
  if (texture.wrap == "mirror") return TextureWrap::Mirror;
  return texture.wrap.empty() || texture.wrap == "wrap" ? TextureWrap::Repeat : TextureWrap::Clamp;
}

/// No value and no word where there is no image: the import has said that.
Result<TexturePyramid> readPyramid(const Texture& texture) {
  if (!hasImage(texture)) return {};
  std::string bytes;
  try {
    bytes = readImage(texture);
  } catch (const std::exception& error) {
    return diagnose(Code::TextureBad, error.what(), {}, texture.path);
  }
  const Result<Picture> picture = decodePicture(bytes, texture.path);
  if (!picture) return diagnose(Code::TextureBad, picture.diagnostics.front().text, {}, texture.path);
  TexturePyramid pyramid = makePyramid(fromTheBottom(*picture), wrapOf(texture));
  while (std::max(pyramid.levels.front().width, pyramid.levels.front().height) > kMostTexels)
    pyramid.levels.erase(pyramid.levels.begin());
  return {std::move(pyramid), picture.diagnostics};
}

std::set<std::int32_t> shownTextures(const ComponentMesh& mesh) {
  std::set<std::int32_t> shown;
  if (mesh.textureCoordinates.empty()) return shown;
  for (const SurfaceInfo& surface : mesh.surfaces) shown.insert(surface.texture);
  return shown;
}

}  // namespace

std::shared_ptr<const ModelLook> readModelLook(const CityModel& city, const ComponentMesh& mesh,
                                               Diagnostics* diagnostics, const Progress& progress) {
  auto look = std::make_shared<ModelLook>();
  for (const Material& material : city.materials) look->materials.push_back(material.diffuse);
  look->textures.resize(city.textures.size());
  for (const std::int32_t texture : shownTextures(mesh)) {
    progress.checkpoint();
    const auto index = static_cast<std::size_t>(texture);
    if (texture < 0 || index >= city.textures.size()) continue;
    Result<TexturePyramid> pyramid = readPyramid(city.textures[index]);
    if (pyramid) look->textures[index] = std::make_shared<const TexturePyramid>(std::move(*pyramid));
    if (diagnostics)
      std::move(pyramid.diagnostics.begin(), pyramid.diagnostics.end(), std::back_inserter(*diagnostics));
  }
  return look;
}

}  // namespace lodestone
