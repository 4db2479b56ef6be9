#include "model/io/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <system_error>

#include <unistd.h>

namespace lodestone {
namespace fs = std::filesystem;
namespace {

// The ending is kept, since some libraries choose a format by it.
fs::path besidePath(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  const std::string name = "." + path.stem().string() + "." + std::to_string(::getpid()) + "-" +
                           std::to_string(counter.fetch_add(1)) + path.extension().string();
  return path.parent_path() / name;
}

[[noreturn]] void fail(const fs::path& path) {
  const int error = errno != 0 ? errno : isFull(path) ? ENOSPC : EIO;
  throw std::system_error(error, std::generic_category(), path.string());
}

}  // namespace

fs::path fileToReplace(const fs::path& path) {
  std::error_code ignored;
  const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
  if (fs::exists(target, ignored) && !fs::is_regular_file(target, ignored))
    throw std::system_error(std::make_error_code(std::errc::not_supported), path.string() + ": not a file");
  return target;
}

MadeFolders::MadeFolders(const fs::path& file) {
  std::error_code ignored;
  for (fs::path folder = file.parent_path(); !folder.empty() && !fs::exists(folder, ignored);
       folder = folder.parent_path()) {
    made_.insert(made_.begin(), folder);
  }
  for (const fs::path& folder : made_) fs::create_directory(folder, ignored);
}

MadeFolders::~MadeFolders() {
  std::error_code ignored;  // what is not empty stays
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, ignored);
}

AtomicFile::AtomicFile(fs::path path)
    : path_(fileToReplace(path)), folders_(path_), temporary_(besidePath(path_)) {
  errno = 0;
  stream_.open(temporaryPath(), std::ios::binary);
  if (!stream_) fail(path_);
}

void AtomicFile::close() {
  if (!stream_.is_open()) return;
  errno = 0;
  stream_.flush();
  if (!stream_) fail(path_);
  stream_.close();
  if (!stream_) fail(path_);
}

void AtomicFile::commit() {
  close();
  std::error_code error;
  fs::rename(temporaryPath(), path_, error);
  if (error) throw std::system_error(error, path_.string());
  folders_.keep();
}

AtomicFiles::~AtomicFiles() {
  while (!files_.empty()) files_.pop_back();  // folders go with the file that made them, the first in them
}

AtomicFile& AtomicFiles::add(const fs::path& path) {
  return *files_.emplace_back(std::make_unique<AtomicFile>(path));
}

void AtomicFiles::add(const fs::path& path, std::string_view bytes) {
  AtomicFile& file = add(path);
  file.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
}

std::vector<fs::path> AtomicFiles::commit() {
  for (const auto& file : files_) file->close();
  for (auto file = files_.rbegin(); file != files_.rend(); ++file) (*file)->commit();
  std::vector<fs::path> paths;
  for (const auto& file : files_) paths.push_back(file->path());
  return paths;
}

bool isFull(const fs::path& path) {
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const fs::space_info space = fs::space(folder, error);
  constexpr std::uintmax_t kNothing = 64 * 1024;
  return !error && space.available < kNothing;
}

void writeFile(const fs::path& path, std::string_view text) {
  AtomicFile file(path);
  file.stream().write(text.data(), static_cast<std::streamsize>(text.size()));
  file.commit();
}

}  // namespace lodestone
