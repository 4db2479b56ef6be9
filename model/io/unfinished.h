// What is being written and has no final name yet.
#pragma once

#include <filesystem>

namespace lodestone {

/// A file or a folder that goes with this object: it is removed, with all that it holds, unless it got
/// another name meanwhile. Never throws.
class Unfinished {
 public:
  explicit Unfinished(std::filesystem::path path);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// For who ends the process at once, when no destructor runs: removes all that is unfinished. From then on
/// threads that begin or end a file wait for good.
void removeAllUnfinished();

}  // namespace lodestone
