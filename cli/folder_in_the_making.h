// A folder of files that belong together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/io/unfinished.h"

namespace lodestone::cli {

/// Gets its name, or gives its files to a folder that is there, when everything is written; without finish()
/// nothing is left. \throw Failure (701) where something else stands in its place
class FolderInTheMaking {
 public:
  explicit FolderInTheMaking(const std::filesystem::path& place);

  /// Where files are written meanwhile.
  [[nodiscard]] const std::filesystem::path& path() const { return unfinished_.path(); }
  [[nodiscard]] const std::filesystem::path& place() const { return place_; }
  /// The files, by their names in the folder, ascending.
  std::vector<std::string> finish();

 private:
  std::filesystem::path place_;
  Unfinished unfinished_;
};

}  // namespace lodestone::cli
