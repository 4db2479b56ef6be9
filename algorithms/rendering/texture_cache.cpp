#include "algorithms/rendering/texture_cache.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <set>
#include <utility>

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

std::size_t bytesOf(const TexturePyramid& pyramid) {
  std::size_t bytes = 0;
  for (const TexturePyramid::Level& level : pyramid.levels) bytes += level.rgba.size();
  return bytes;
}

std::set<std::int32_t> shownTextures(const ComponentMesh& mesh) {
  std::set<std::int32_t> shown;
  if (mesh.textureCoordinates.empty()) return shown;
  for (const SurfaceInfo& surface : mesh.surfaces) shown.insert(surface.texture);
  return shown;
}

}  // namespace

TextureCache::TextureCache(const CityModel& city, std::size_t budget)
    : city_(city), budget_(budget), entries_(city.textures.size()) {}

std::shared_ptr<const TexturePyramid> TextureCache::get(std::size_t texture, Diagnostics* diagnostics) {
  Entry& entry = entries_[texture];
  const std::lock_guard decoding(entry.decoding);
  if (auto image = known(entry)) return image;
  if (entry.isBad) return nullptr;
  Result<TexturePyramid> pyramid = readPyramid(city_.textures[texture]);
  if (diagnostics)
    std::move(pyramid.diagnostics.begin(), pyramid.diagnostics.end(), std::back_inserter(*diagnostics));
  entry.isBad = !pyramid;
  if (!pyramid) return nullptr;
  auto image = std::make_shared<const TexturePyramid>(std::move(*pyramid));
  keep(entry, image);
  return image;
}

std::shared_ptr<const TexturePyramid> TextureCache::known(Entry& entry) {
  const std::lock_guard lock(mutex_);
  entry.lastUse = ++uses_;
  return entry.image;
}

void TextureCache::keep(Entry& entry, const std::shared_ptr<const TexturePyramid>& image) {
  const std::lock_guard lock(mutex_);
  entry.image = image;
  bytes_ += bytesOf(*image);
  while (bytes_ > budget_) {
    const auto oldest =
        std::min_element(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
          return std::pair(!a.image, a.lastUse) < std::pair(!b.image, b.lastUse);
        });
    bytes_ -= bytesOf(*oldest->image);
    oldest->image = nullptr;
  }
}

std::shared_ptr<const ModelLook> readModelLook(TextureCache& cache, const ComponentMesh& mesh,
                                               Diagnostics* diagnostics, const Progress& progress) {
  auto look = std::make_shared<ModelLook>();
  for (const Material& material : cache.city().materials) look->materials.push_back(material.diffuse);
  look->textures.resize(cache.city().textures.size());
  for (const std::int32_t texture : shownTextures(mesh)) {
    progress.checkpoint();
    const auto index = static_cast<std::size_t>(texture);
    if (texture >= 0 && index < look->textures.size()) look->textures[index] = cache.get(index, diagnostics);
  }
  return look;
}

std::shared_ptr<const ModelLook> readModelLook(const CityModel& city, const ComponentMesh& mesh,
                                               Diagnostics* diagnostics, const Progress& progress) {
  TextureCache cache(city);
  return readModelLook(cache, mesh, diagnostics, progress);
}

}  // namespace lodestone
