// Textures of meshes that assimp reads, and how they go on beyond their edges.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <assimp/scene.h>

#include "model/city_model.h"
#include "model/diagnostics.h"
#include "model/io/image_path.h"

namespace lodestone {

/// Adds each image that materials name to a model's textures, once for each way in which it goes on
/// (Texture::wrap): glTF's samplers, OBJ's -clamp, the wrapU, mirrorU and so on that COLLADA files have from
/// Maya and OpenCOLLADA. A texture has one way for both axes; where a file says two, the one that goes on.
class MeshTextures {
 public:
  /// All four outlive it. What is wrong with an image is said in `diagnostics`.
  MeshTextures(const std::filesystem::path& file, bool allowOutside, std::vector<Texture>& textures,
               Diagnostics& diagnostics);

  /// The number of a material's texture; -1: it has none.
  [[nodiscard]] std::int32_t of(const aiScene& scene, const aiMaterial& material);
  /// That of an image beside the file.
  [[nodiscard]] std::int32_t named(const std::string& name, const std::string& wrap = {});

 private:
  [[nodiscard]] std::int32_t inside(const std::string& name, const aiTexture& image, const std::string& wrap);
  [[nodiscard]] std::string nameOf(const aiTexture& image) const;
  std::int32_t add(Texture texture);

  const std::filesystem::path& file_;
  ImagePaths images_;
  std::vector<Texture>& textures_;
  Diagnostics& diagnostics_;
  /// Images inside the file, by the names it gives them and how they go on.
  std::map<std::pair<std::string, std::string>, std::int32_t> inside_;
};

}  // namespace lodestone
