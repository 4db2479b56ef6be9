// Files that are whole or not there: written beside their place and renamed when complete.
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace lodestone {

/// Usage: AtomicFile out(path); out.stream() << …; out.commit(). Without commit() nothing is left.
/// \throw std::system_error with a readable message when the file cannot be made, written or renamed.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  [[nodiscard]] std::ostream& stream() { return stream_; }
  /// For libraries that open files themselves: write here, then commit().
  [[nodiscard]] const std::filesystem::path& temporaryPath() const { return temporary_; }
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes the whole text. \throw std::system_error
void writeFile(const std::filesystem::path& path, std::string_view text);

}  // namespace lodestone
