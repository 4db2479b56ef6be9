#include "model/io/image_path.h"

#include <algorithm>
#include <system_error>

#include "model/io/input_file.h"

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

/// GDAL's own paths can lead into a network as well.
bool isOnNetwork(std::string_view name) {
  return name.find("://") != std::string_view::npos || name.starts_with("/vsi");
}

/// A compressed file lies where it lies; only members of archives are in a folder of their own.
fs::path realPlace(const fs::path& file) {
  constexpr std::string_view kGzip = "/vsigzip/";
  const std::string path = file.string();
  return path.starts_with(kGzip) ? fs::path(path.substr(kGzip.size())) : file;
}

}  // namespace

ImagePaths::ImagePaths(const fs::path& inputFile, bool allowOutside) : allowOutside_(allowOutside) {
  std::error_code error;
  folder_ = fs::weakly_canonical(fs::absolute(realPlace(inputFile), error).parent_path(), error);
}

Texture ImagePaths::find(std::string_view name, Diagnostics& diagnostics) const {
  Texture texture;
  texture.path = name;
  texture.missing = true;
  if (isOnNetwork(name)) {
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
  } else if (!fileExists(full.string())) {
    diagnostics.push_back(diagnose(Code::TextureMissing, texture.path));
  } else {
    texture.path = full.string();
    texture.missing = false;
  }
  return texture;
}

}  // namespace lodestone
