// A GLB file in the making: its JSON grows as its binary part is spooled.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/io/atomic_file.h"
#include "model/io/meshes/glb_mesh.h"
#include "model/io/meshes/glb_table.h"

namespace lodestone {

/// Whether binary glTF can hold the image: a PNG or JPEG that is there.
[[nodiscard]] bool glbHoldsImage(const Texture& texture);

class GlbDocument {
 public:
  /// The binary part is kept in a file beside `path` until finish(). \throw std::system_error
  GlbDocument(std::shared_ptr<const CityModel> city, const std::filesystem::path& path);

  /// Of each of the city's textures, whether it is an image that glTF can hold: a PNG or JPEG that is there.
  [[nodiscard]] const std::vector<bool>& usableTextures() const { return usableTextures_; }
  /// A mesh and its node. False when the disk is full.
  bool addMesh(const GlbMesh& mesh);
  /// Writes the whole file. `extras` goes into asset.extras. \throw std::system_error
  void finish(const GlbTable& table, const nlohmann::ordered_json& extras, std::ostream& out);

 private:
  std::size_t addView(std::string_view bytes, const std::string& more = {});
  void addPrimitives(const GlbMesh& mesh);
  template <class Vector>
  std::size_t addVectors(std::size_t view, std::size_t offset, const std::vector<Vector>& values,
                         bool withBounds);
  std::size_t addIndices(const GlbPrimitive& primitive);
  std::size_t materialOf(const GlbMaterialKey& key);
  [[nodiscard]] std::string plainMaterial(const GlbMaterialKey& key) const;
  std::string texturedMaterial(std::int32_t texture);
  void pad(std::size_t alignment);
  [[nodiscard]] std::string json(const std::string& extensions, const nlohmann::ordered_json& extras) const;

  /// The items of one of the document's arrays, as JSON text.
  struct Items {
    fmt::memory_buffer text;
    std::size_t count = 0;
    std::size_t add(std::string_view item);
  };

  std::shared_ptr<const CityModel> city_;
  std::vector<bool> usableTextures_;
  AtomicFile spool_;  // never committed: gone with this
  std::uint64_t size_ = 0;
  std::map<GlbMaterialKey, std::size_t> materialIndex_;
  Items views_, accessors_, meshes_, nodes_, materials_, textures_, samplers_, images_;
};

}  // namespace lodestone
