#include "cli/folder_in_the_making.h"

#include <algorithm>

#include <fmt/format.h>
#include <unistd.h>

#include "cli/written_files.h"

namespace lodestone::cli {
namespace {

namespace fs = std::filesystem;

/// On the file system that the folder is on, since files are renamed into it: inside one that is there, which
/// may be mounted, or a link to elsewhere.
fs::path besideOrInside(const fs::path& place) {
  const std::string ending = fmt::format(".unfinished-{}", getpid());
  return fs::is_directory(place) ? fs::canonical(place) / ending : fs::path(place.string() + ending);
}

}  // namespace

FolderInTheMaking::FolderInTheMaking(const fs::path& place)
    : place_((place / "").parent_path()), unfinished_(besideOrInside(place_)) {
  requireFolder(place_);
  fs::create_directories(unfinished_.path());
}

std::vector<std::string> FolderInTheMaking::finish() {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(path())) files.push_back(entry.path().filename().string());
  std::sort(files.begin(), files.end());
  fs::create_directories(place_);
  for (const std::string& file : files) fs::rename(path() / file, place_ / file);
  return files;
}

}  // namespace lodestone::cli
