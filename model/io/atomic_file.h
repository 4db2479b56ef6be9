// Files that are whole or not there: written beside their place and renamed when complete.
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <vector>

#include "model/io/unfinished.h"

namespace lodestone {

/// The file that stands for `path`: renaming over a link would put a file in its place, over a device or a
/// pipe the same. \throw std::system_error for what is there and is no file
[[nodiscard]] std::filesystem::path fileToReplace(const std::filesystem::path& path);

/// Makes the folders on the way to a file. Those that were not there go again with this, unless kept or
/// filled by others meanwhile. Never throws: who writes there finds out.
class MadeFolders {
 public:
  explicit MadeFolders(const std::filesystem::path& file);
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  void keep() { made_.clear(); }

 private:
  std::vector<std::filesystem::path> made_;  ///< outermost first
};

/// Usage: AtomicFile out(path); out.stream() << …; out.commit(). Without commit() nothing is left, nor are
/// the folders that were made for it. A link is followed; what is no file (a device, a pipe, a folder) is
/// never replaced. \throw std::system_error with a readable message when the file cannot be made, written or
/// renamed.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile() = default;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  [[nodiscard]] std::ostream& stream() { return stream_; }
  /// For libraries that open files themselves: write here, then commit().
  [[nodiscard]] const std::filesystem::path& temporaryPath() const { return temporary_.path(); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Ends the writing, and no sooner says that the disk was full; the file waits for commit() and holds no
  /// descriptor.
  void close();
  void commit();

 private:
  std::filesystem::path path_;
  MadeFolders folders_;
  Unfinished temporary_;
  std::ofstream stream_;
};

/// Files that belong together: all are written before the first gets its name. Few should be open at a time:
/// close() what is done. Without commit() nothing is left.
class AtomicFiles {
 public:
  AtomicFiles() = default;
  ~AtomicFiles();
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;

  AtomicFile& add(const std::filesystem::path& path);
  /// A file of these bytes, closed.
  void add(const std::filesystem::path& path, std::string_view bytes);
  /// Closes and renames all, the last added first: the first is the one that names the others, so that where
  /// it is, they are. Returns the paths in the order added.
  std::vector<std::filesystem::path> commit();

 private:
  std::vector<std::unique_ptr<AtomicFile>> files_;
};

/// Whether the disk of the path's folder has no room. The write that failed may be long ago and its errno
/// lost: this says why.
[[nodiscard]] bool isFull(const std::filesystem::path& path);

/// Writes the whole text. \throw std::system_error
void writeFile(const std::filesystem::path& path, std::string_view text);

}  // namespace lodestone
