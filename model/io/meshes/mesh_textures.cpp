#include "model/io/meshes/mesh_textures.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include <assimp/material.h>
#include <fmt/format.h>

namespace lodestone {
namespace {

/// CityJSON's word for how a texture goes on beyond its edges. Where the axes differ, it goes on along both:
/// one that stays inside shows no difference, one that stays inside shows no difference, one that does not
/// would lose its picture.
std::string wrapOf(const aiMaterial& material, aiTextureType type) {
  constexpr std::array<std::string_view, 4> kWords{"wrap", "mirror", "clamp", "none"};  // what goes on, first
  constexpr std::array<aiTextureMapMode, 4> kModes{aiTextureMapMode_Wrap, aiTextureMapMode_Mirror,
                                                   aiTextureMapMode_Clamp, aiTextureMapMode_Decal};
  std::size_t best = kModes.size();
  for (const char* key : {_AI_MATKEY_MAPPINGMODE_U_BASE, _AI_MATKEY_MAPPINGMODE_V_BASE}) {
    int mode = 0;
    if (material.Get(key, type, 0, mode) != AI_SUCCESS) continue;
    best = std::min(best,
                    static_cast<std::size_t>(std::find(kModes.begin(), kModes.end(), mode) - kModes.begin()));
  }
  return best < kWords.size() ? std::string(kWords[best]) : std::string();
}

}  // namespace

MeshTextures::MeshTextures(const std::filesystem::path& file, bool allowOutside,
                           std::vector<Texture>& textures, Diagnostics& diagnostics)
    : file_(file), images_(file, allowOutside), textures_(textures), diagnostics_(diagnostics) {}

std::int32_t MeshTextures::of(const aiScene& scene, const aiMaterial& material) {
  for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
    aiString name;
    if (material.GetTexture(type, 0, &name) != AI_SUCCESS) continue;
    const std::string wrap = wrapOf(material, type);
    const aiTexture* image = scene.GetEmbeddedTexture(name.C_Str());
    return image ? inside(name.C_Str(), *image, wrap) : named(name.C_Str(), wrap);
  }
  return -1;
}

std::int32_t MeshTextures::named(const std::string& name, const std::string& wrap) {
  Texture texture = images_.find(name, diagnostics_);
  texture.wrap = wrap;
  const auto known = std::find_if(textures_.begin(), textures_.end(), [&](const Texture& other) {
    return other.path == texture.path && other.wrap == wrap;
  });
  if (known != textures_.end()) return static_cast<std::int32_t>(known - textures_.begin());
  return add(std::move(texture));
}

std::int32_t MeshTextures::inside(const std::string& name, const aiTexture& image, const std::string& wrap) {
  const auto known = inside_.find({name, wrap});
  if (known != inside_.end()) return known->second;
  Texture texture;
  texture.path = nameOf(image);
  texture.wrap = wrap;
  if (image.mHeight == 0) {
    texture.embedded =
        std::make_shared<const std::string>(reinterpret_cast<const char*>(image.pcData), image.mWidth);
  } else {  // bare texels, as no format of ours holds them
    texture.missing = true;
    diagnostics_.push_back(diagnose(
        Code::TextureMissing, texture.path + ", inside the file, is no PNG or JPEG", {}, file_.string()));
  }
  return inside_[{name, wrap}] = add(std::move(texture));
}

/// A file name for an image inside the file.
std::string MeshTextures::nameOf(const aiTexture& image) const {
  const std::string ending = std::string(".") + image.achFormatHint;
  const std::string given = std::filesystem::path(image.mFilename.C_Str()).filename().string();
  if (given.empty()) return fmt::format("{}-{}{}", file_.stem().string(), inside_.size(), ending);
  return given.ends_with(ending) ? given : given + ending;
}

std::int32_t MeshTextures::add(Texture texture) {
  textures_.push_back(std::move(texture));
  return static_cast<std::int32_t>(textures_.size()) - 1;
}

}  // namespace lodestone
