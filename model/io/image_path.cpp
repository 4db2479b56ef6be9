#include "model/io/image_path.h"

#include <algorithm>
#include <system_error>

namespace lodestone {
namespace fs = std::filesystem;
namespace {

bool isBelow(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

// Windows' separators are common in real files.
std::string withSlashes(std::string_view name) {
  std::string result(name);
  std::replace(result.begin(), result.end(), '\\', '/');
  return result;
}

}  // namespace

ImagePaths::ImagePaths(const fs::path& inputFile, bool allowOutside) : allowOutside_(allowOutside) {
  std::error_code error;
  folder_ = fs::weakly_canonical(fs::absolute(inputFile, error).parent_path(), error);
}

Texture ImagePaths::find(std::string_view name, Diagnostics& diagnostics) const {
  Texture texture;
  texture.path = name;
  texture.missing = true;
  if (name.find("://") != std::string_view::npos) {
    diagnostics.push_back(diagnose(Code::TextureMissing, texture.path + " is on a network"));
    return texture;
  }
  std::error_code error;
  // Links are followed before the check: a link inside the folder must not lead out of it either.
  const fs::path full = fs::weakly_canonical(folder_ / withSlashes(name), error);
  if (error || name.empty()) {
    diagnostics.push_back(diagnose(Code::TextureMissing, texture.path));
  } else if (!allowOutside_ && !isBelow(full, folder_)) {
    diagnostics.push_back(diagnose(Code::TextureOutside, texture.path));
  } else if (!fs::is_regular_file(full, error)) {
    diagnostics.push_back(diagnose(Code::TextureMissing, texture.path));
  } else {
    texture.path = full.string();
    texture.missing = false;
  }
  return texture;
}

}  // namespace lodestone
