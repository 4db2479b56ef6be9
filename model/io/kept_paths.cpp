#include "model/io/kept_paths.h"

#include <system_error>

namespace lodestone {
namespace fs = std::filesystem;
namespace {

/// The path without links, "." and "..", as far as it is there.
fs::path trueFolder(const fs::path& folder) {
  std::error_code error;
  const fs::path absolute = fs::absolute(folder, error);
  const fs::path found = fs::weakly_canonical(absolute, error);
  return error ? absolute.lexically_normal() : found;
}

}  // namespace

std::vector<std::string> keptPaths(const std::vector<std::string>& paths, const fs::path& folder) {
  const fs::path from = trueFolder(folder);
  std::vector<std::string> kept;
  kept.reserve(paths.size());
  for (const fs::path path : paths) {
    const fs::path whole = trueFolder(path.has_parent_path() ? path.parent_path() : ".") / path.filename();
    const fs::path relative = whole.lexically_relative(from);
    kept.push_back((relative.empty() ? whole : relative).generic_string());
  }
  return kept;
}

std::vector<std::string> pathsFromKept(const std::vector<std::string>& kept, const fs::path& folder) {
  const fs::path from = trueFolder(folder);
  std::vector<std::string> paths;
  paths.reserve(kept.size());
  for (const std::string& path : kept) paths.push_back((from / path).lexically_normal().string());
  return paths;
}

}  // namespace lodestone
