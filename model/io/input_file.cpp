#include "model/io/input_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>
#include <tuple>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

namespace lodestone {
namespace {

constexpr std::uint64_t kGreatestRatio = 200;
constexpr std::uint64_t kAlwaysAllowed = std::uint64_t{1} << 30;
/// XML and JSON of city models pack to about a tenth: good enough for a progress bar.
constexpr double kUsualGzipRatio = 10;

constexpr std::string_view kVsi = "/vsi";
constexpr std::string_view kGzip = "/vsigzip/";
constexpr std::string_view kZip = "/vsizip/";
constexpr std::array<std::string_view, 3> kAllowedSystems{"zip/", "gzip/", "mem/"};

/// Endings of city models, the likeliest first: XML is also used for code lists and JSON for metadata.
constexpr std::array<std::string_view, 12> kEndings{".gml",      ".citygml", ".city.json", ".city.jsonl",
                                                    ".jsonl",    ".xml",     ".json",      ".geojson",
                                                    ".geojsonl", ".gpkg",    ".fgb",       ".shp"};

/// GDAL prints its errors on stderr; ours go into diagnostics.
class QuietGdal {
 public:
  QuietGdal() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~QuietGdal() { CPLPopErrorHandler(); }
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
};

[[noreturn]] void fail(std::errc code, const std::string& what) {
  throw std::system_error(std::make_error_code(code), what);
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string absoluteName(const std::filesystem::path& path) {
  std::error_code error;
  const auto absolute = std::filesystem::absolute(path, error);
  return error ? path.string() : absolute.string();
}

std::string magicOf(const std::filesystem::path& path, std::size_t count) {
  std::ifstream file(path, std::ios::binary);
  std::string magic(count, '\0');
  file.read(magic.data(), static_cast<std::streamsize>(count));
  magic.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return magic;
}

/// GDAL's virtual paths can reach the network (/vsicurl/) or run through other drivers: only the local ones
/// are opened.
bool isAllowed(std::string_view path) {
  if (!path.starts_with(kVsi)) return true;
  for (std::size_t at = 0; at != std::string_view::npos; at = path.find(kVsi, at + 1)) {
    const std::string_view rest = path.substr(at + kVsi.size());
    if (std::none_of(kAllowedSystems.begin(), kAllowedSystems.end(),
                     [&](std::string_view system) { return rest.starts_with(system); })) {
      return false;
    }
  }
  return true;
}

/// The real file behind a virtual path: "/vsizip/{/a/b.zip}/c.gml" -> "/a/b.zip".
std::string fileBehind(std::string path) {
  if (path.starts_with(kGzip)) return fileBehind(path.substr(kGzip.size()));
  if (path.starts_with(kZip)) {
    const std::size_t begin = path.find('{');
    const std::size_t end = path.rfind('}');
    if (begin != std::string::npos && end != std::string::npos && begin < end) {
      return fileBehind(path.substr(begin + 1, end - begin - 1));
    }
    const std::size_t ending = lower(path).find(".zip");
    return fileBehind(
        path.substr(kZip.size(), ending == std::string::npos ? ending : ending + 4 - kZip.size()));
  }
  return path;
}

bool leavesArchive(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return name.starts_with('/') || name == ".." || name.starts_with("../") || name.ends_with("/..") ||
         name.find("/../") != std::string::npos || (name.size() > 1 && name[1] == ':');
}

/// Place in kEndings; kEndings.size() for what cannot be a city model.
std::size_t rankOf(const std::string& name) {
  const std::string small = lower(name);
  const std::size_t slash = small.rfind('/');
  const std::string_view base = std::string_view(small).substr(slash == std::string::npos ? 0 : slash + 1);
  // Finder's copies of resource forks bear the names of the real files.
  if (base.starts_with("._") || small.starts_with("__macosx/")) return kEndings.size();
  const auto it = std::find_if(kEndings.begin(), kEndings.end(),
                               [&](std::string_view ending) { return small.ends_with(ending); });
  return static_cast<std::size_t>(it - kEndings.begin());
}

std::uint64_t sizeOf(const std::string& path) {
  VSIStatBufL status;
  const bool found = VSIStatExL(path.c_str(), &status, VSI_STAT_EXISTS_FLAG | VSI_STAT_SIZE_FLAG) == 0;
  return found ? static_cast<std::uint64_t>(status.st_size) : 0;
}

bool isBomb(std::uint64_t packed, std::uint64_t unpacked) {
  return unpacked > kAlwaysAllowed && unpacked / kGreatestRatio > packed;
}

std::uint32_t littleEndian(std::string_view bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = count; i-- > 0;)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

/// Names in a zip archive's central directory (APPNOTE 4.3.12, without zip64). GDAL drops names that climb
/// out without a word; they are to be said.
std::vector<std::string> namesInDirectory(const std::string& archive) {
  constexpr std::size_t kEndRecord = 22;
  constexpr std::size_t kLongestComment = 65535;
  constexpr std::size_t kEntry = 46;
  std::vector<std::string> names;
  std::ifstream file(archive, std::ios::binary);
  const std::uint64_t size = sizeOf(archive);
  const auto bytesAt = [&](std::uint64_t begin, std::uint64_t count) {
    std::string bytes(static_cast<std::size_t>(count), '\0');
    file.seekg(static_cast<std::streamoff>(begin));
    if (!file.read(bytes.data(), static_cast<std::streamsize>(count))) bytes.clear();
    return bytes;
  };
  const std::uint64_t tailSize = std::min<std::uint64_t>(size, kEndRecord + kLongestComment);
  const std::string tail = bytesAt(size - tailSize, tailSize);
  const std::size_t end = tail.rfind("PK\x05\x06");
  if (end == std::string::npos || end + kEndRecord > tail.size()) return names;
  const std::uint32_t length = littleEndian(tail, end + 12, 4);
  const std::uint32_t begin = littleEndian(tail, end + 16, 4);
  if (std::uint64_t{begin} + length > size) return names;
  const std::string directory = bytesAt(begin, length);
  for (std::size_t at = 0; at + kEntry <= directory.size() && directory.compare(at, 4, "PK\x01\x02") == 0;) {
    const std::size_t nameLength = littleEndian(directory, at + 28, 2);
    names.push_back(directory.substr(at + kEntry, nameLength));
    at += kEntry + nameLength + littleEndian(directory, at + 30, 2) + littleEndian(directory, at + 32, 2);
  }
  return names;
}

struct Members {
  std::vector<std::pair<std::size_t, std::string>> usable;  ///< rank and name in the archive
  std::uint64_t unpacked = 0;
  Diagnostics diagnostics;
};

Members listMembers(const std::string& root, const std::string& archive) {
  Members members;
  VSIDIR* directory = VSIOpenDir(root.c_str(), -1, nullptr);
  if (!directory) {
    members.diagnostics.push_back(diagnose(Code::FileMalformed, "not a readable zip archive", {}, archive));
    return members;
  }
  while (const VSIDIREntry* entry = VSIGetNextDirEntry(directory)) {
    if (VSI_ISDIR(entry->nMode)) continue;
    members.unpacked += entry->nSize;
    const std::string name = entry->pszName;
    const std::size_t rank = rankOf(name);
    if (rank < kEndings.size() && !leavesArchive(name)) members.usable.emplace_back(rank, name);
  }
  VSICloseDir(directory);
  return members;
}

}  // namespace

std::string virtualPath(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (name.starts_with(kVsi)) return name;
  const bool gzipped = lower(name).ends_with(".gz") || magicOf(path, 2) == "\x1f\x8b";
  return gzipped ? std::string(kGzip) + absoluteName(path) : name;
}

bool isArchive(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (name.starts_with(kVsi)) return false;
  const std::string magic = magicOf(path, 4);
  return magic == "PK\x03\x04" || magic == "PK\x05\x06";
}

Result<std::vector<std::string>> archiveMembers(const std::filesystem::path& path) {
  const QuietGdal quiet;
  const std::string archive = absoluteName(path);
  const std::string root = std::string(kZip) + "{" + archive + "}";
  Members members = listMembers(root, path.filename().string());
  for (const std::string& name : namesInDirectory(archive)) {
    if (leavesArchive(name)) {
      members.diagnostics.push_back(diagnose(Code::ArchiveUnsafe, name, {}, path.filename().string()));
    }
  }
  if (isBomb(sizeOf(archive), members.unpacked)) {
    members.diagnostics.push_back(
        diagnose(Code::ArchiveUnsafe, "it claims to unpack to " + std::to_string(members.unpacked) + " bytes",
                 {}, path.filename().string()));
    return Result<std::vector<std::string>>::failure(std::move(members.diagnostics));
  }
  if (members.usable.empty()) {
    if (!hasErrors(members.diagnostics)) {
      members.diagnostics.push_back(diagnose(Code::ArchiveEmpty, {}, {}, path.filename().string()));
    }
    return Result<std::vector<std::string>>::failure(std::move(members.diagnostics));
  }
  std::sort(members.usable.begin(), members.usable.end());
  std::vector<std::string> names;
  for (const auto& [rank, name] : members.usable) names.push_back(root + "/" + name);
  return {std::move(names), std::move(members.diagnostics)};
}

bool fileExists(const std::string& virtualPath) {
  const QuietGdal quiet;
  VSIStatBufL status;
  return isAllowed(virtualPath) &&
         VSIStatExL(virtualPath.c_str(), &status, VSI_STAT_EXISTS_FLAG | VSI_STAT_NATURE_FLAG) == 0 &&
         VSI_ISREG(status.st_mode);
}

std::string readHead(const std::filesystem::path& path, std::size_t count) {
  std::string name = virtualPath(path);
  if (isArchive(path)) {
    const auto members = archiveMembers(path);
    if (!members) return {};
    name = members->front();
  }
  try {
    InputFile file(name);
    std::string head(count, '\0');
    head.resize(file.read(head.data(), count));
    return head;
  } catch (const std::system_error&) {
    return {};  // what is wrong with the file is said by the reader that is chosen by its ending
  }
}

struct InputFile::Impl {
  std::string name;
  VSILFILE* file = nullptr;
  bool packed = false;
  std::uint64_t packedSize = 0;
  double expectedSize = 0;
  std::uint64_t bytesRead = 0;
};

InputFile::InputFile(const std::string& virtualPath) : impl_(std::make_unique<Impl>()) {
  const QuietGdal quiet;
  impl_->name = virtualPath;
  if (!isAllowed(virtualPath)) fail(std::errc::operation_not_permitted, virtualPath);
  const std::string behind = fileBehind(virtualPath);
  std::error_code error;
  if (std::filesystem::is_directory(behind, error)) fail(std::errc::is_a_directory, virtualPath);
  errno = 0;
  impl_->file = VSIFOpenL(virtualPath.c_str(), "rb");
  if (!impl_->file)
    fail(errno == 0 ? std::errc::no_such_file_or_directory : static_cast<std::errc>(errno), virtualPath);
  impl_->packed = behind != virtualPath;
  impl_->packedSize = sizeOf(behind);
  // Asking for the size of gzipped content would unpack all of it (and leave a side file): guess.
  impl_->expectedSize = virtualPath.starts_with(kGzip)
                            ? kUsualGzipRatio * static_cast<double>(impl_->packedSize)
                            : static_cast<double>(sizeOf(virtualPath));
}

InputFile::~InputFile() {
  if (impl_->file) VSIFCloseL(impl_->file);
}

std::size_t InputFile::read(char* buffer, std::size_t size) {
  const QuietGdal quiet;
  const std::size_t count = VSIFReadL(buffer, 1, size, impl_->file);
  impl_->bytesRead += count;
  if (impl_->packed && isBomb(impl_->packedSize, impl_->bytesRead)) {
    fail(std::errc::file_too_large, impl_->name + " unpacks to over 200 times its size");
  }
  if (count == 0 && (VSIFEofL(impl_->file) == 0 || CPLGetLastErrorType() >= CE_Failure)) {
    fail(std::errc::io_error, impl_->name);
  }
  return count;
}

std::uint64_t InputFile::packedSize() const {
  return impl_->packedSize;
}
std::uint64_t InputFile::bytesRead() const {
  return impl_->bytesRead;
}

double InputFile::shareRead() const {
  if (impl_->expectedSize <= 0) return 0;
  return std::min(1.0, static_cast<double>(impl_->bytesRead) / impl_->expectedSize);
}

std::string readWholeFile(const std::filesystem::path& path) {
  InputFile file(virtualPath(path));
  std::string text;
  std::size_t room = std::size_t{1} << 16;
  for (;;) {
    const std::size_t used = text.size();
    text.resize(used + room);
    const std::size_t count = file.read(text.data() + used, room);
    text.resize(used + count);
    if (count == 0) return text;
    room = std::max(room, text.size());
  }
}

}  // namespace lodestone
