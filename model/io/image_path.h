// Texture images named by an input file.
#pragma once

#include <filesystem>
#include <string_view>

#include "model/city_model.h"
#include "model/diagnostics.h"

namespace lodestone {

/// Finds images relative to the folder of an input file, which may be a member of an archive (a virtual
/// path). Names that leave the folder are refused unless allowed; nothing is fetched from a network.
class ImagePaths {
 public:
  ImagePaths(const std::filesystem::path& inputFile, bool allowOutside);

  /// Path and `missing` of a texture. What is wrong is said (TextureMissing, TextureOutside).
  [[nodiscard]] Texture find(std::string_view name, Diagnostics& diagnostics) const;

 private:
  std::filesystem::path folder_;
  bool allowOutside_;
};

}  // namespace lodestone
