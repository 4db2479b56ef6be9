// Input files as streams of bytes: plain, gzipped, or members of a zip archive, by GDAL's virtual file
// system. Virtual paths that would reach the network are refused.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "model/result.h"

namespace lodestone {

/// GDAL's name of the file's content: "/vsigzip/…" for .gz, the path itself otherwise. Zip archives: see
/// archiveMembers().
[[nodiscard]] std::string virtualPath(const std::filesystem::path& path);

/// Virtual paths of an archive's members that could be city models by their endings, CityGML before CityJSON
/// before other XML and JSON before vector layers, then in name order. Members whose path leaves the archive
/// are refused (ArchiveUnsafe), and so is an archive that claims to unpack to over 200 times its size and 1
/// GiB.
[[nodiscard]] Result<std::vector<std::string>> archiveMembers(const std::filesystem::path& path);
[[nodiscard]] bool isArchive(const std::filesystem::path& path);

/// True for an existing file, by path or virtual path. Never asks the network.
[[nodiscard]] bool fileExists(const std::string& virtualPath);

/// The first bytes of the (unpacked) file, at most `count`; empty when it cannot be read. Of an archive: of
/// its first member.
[[nodiscard]] std::string readHead(const std::filesystem::path& path, std::size_t count = 4096);

/// Sequential reader of a virtual path.
class InputFile {
 public:
  /// \throw std::system_error when the file cannot be opened, or is a folder.
  explicit InputFile(const std::string& virtualPath);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Bytes read into `buffer`; 0 at the end. \throw std::system_error: file_too_large when a compressed file
  /// unpacks to over 200 times its size and 1 GiB, io_error when it cannot be read. A gzipped file that is
  /// cut off ends early, as a plain one would.
  std::size_t read(char* buffer, std::size_t size);
  /// Bytes of the (packed) file behind it, for progress; 0 if unknown.
  [[nodiscard]] std::uint64_t packedSize() const;
  [[nodiscard]] std::uint64_t bytesRead() const;
  /// Share of the content read so far, 0–1, for progress; a guess for gzipped files, whose size is not known.
  [[nodiscard]] double shareRead() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The whole (unpacked) file, not an archive. \throw std::system_error
[[nodiscard]] std::string readWholeFile(const std::filesystem::path& path);

}  // namespace lodestone
