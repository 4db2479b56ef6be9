#include <algorithm>
#include <array>
#include <cctype>
#include <new>
#include <span>
#include <string_view>
#include <system_error>

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "algorithms/rendering/pictures/picture_module.h"
#include "algorithms/rendering/png_check.h"
#include "algorithms/rendering/rendering.h"
#include "model/io/atomic_file.h"
#include "model/io/input_file.h"
#include "model/io/output_failure.h"

namespace lodestone {
namespace fs = std::filesystem;
namespace {

constexpr const char* kModule = "lib/lodestone/lodestone_pictures.so";

/// The loaded module; it stays until the program ends.
struct PictureModule {
  LodestoneCanWritePicture canWrite = nullptr;
  LodestoneWritePicture write = nullptr;
  LodestoneReadPicture read = nullptr;
  std::string error;
};

/// lib/lodestone beside or above the program's folder: where it is installed, and in a build folder, wherever
/// that has been moved to.
PictureModule loadModule() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  PictureModule module;
  module.error = "no lib/lodestone/lodestone_pictures.so above " + program.string();
  fs::path folder = program.parent_path();
  fs::path file;
  // Where it is installed one step up, in a build folder at most two; farther up stands what is others'.
  for (int steps = 0; steps < 2 && folder.has_relative_path() && !fs::exists(file, ignored); ++steps) {
    folder = folder.parent_path();
    file = folder / kModule;
  }
  if (!fs::exists(file, ignored)) return module;
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) {
    module.error = dlerror();
    return module;
  }
  module.canWrite = reinterpret_cast<LodestoneCanWritePicture>(dlsym(handle, "lodestoneCanWritePicture"));
  module.write = reinterpret_cast<LodestoneWritePicture>(dlsym(handle, "lodestoneWritePicture"));
  module.read = reinterpret_cast<LodestoneReadPicture>(dlsym(handle, "lodestoneReadPicture"));
  return module;
}

const PictureModule& pictureModule() {
  static const PictureModule module = loadModule();
  return module;
}

// With eight bits a channel and without a palette.
constexpr std::array<std::string_view, 7> kEndings{".png", ".jpg", ".jpeg", ".tif", ".tiff", ".webp", ".bmp"};

// That are read, but not written.
constexpr std::array<std::string_view, 5> kReadEndings{".ppm", ".pgm", ".pbm", ".pnm", ".tga"};

constexpr int kLongestSide = 32768;
constexpr std::size_t kMostBytes = std::size_t{1} << 29;

/// How the files of a format begin; OpenImageIO's name of it.
struct Beginning {
  std::string_view bytes;
  std::string_view format;
};
constexpr std::array<Beginning, 7> kBeginnings{{{"\x89PNG\r\n\x1a\n", "png"},
                                                {"\xff\xd8\xff", "jpeg"},
                                                {{"II*\0", 4}, "tiff"},
                                                {{"MM\0*", 4}, "tiff"},
                                                {{"II+\0", 4}, "tiff"},
                                                {{"MM\0+", 4}, "tiff"},
                                                {"BM", "bmp"}}};

std::string lowerEnding(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

bool isOneOf(std::span<const std::string_view> endings, const std::string& ending) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// By what the file holds, since many a texture is named .jpg and is a PNG; TGA alone has no beginning of its
/// own. Empty: none of ours. The other formats of OpenImageIO are not asked: they cannot all be trusted with
/// whatever stands in a file.
std::string_view formatOf(std::string_view bytes, const std::string& name) {
  for (const Beginning& beginning : kBeginnings) {
    if (bytes.starts_with(beginning.bytes)) return beginning.format;
  }
  if (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP")) return "webp";
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6' &&
      (std::isspace(static_cast<unsigned char>(bytes[2])) != 0 || bytes[2] == '#'))
    return "pnm";
  return lowerEnding(name) == ".tga" ? "targa" : "";
}

/// Several errors of a library, a line each.
std::string inOneLine(std::string message) {
  for (std::size_t at = 0; (at = message.find('\n', at)) != std::string::npos;) message.replace(at, 1, "; ");
  return message;
}

unsigned char* roomIn(void* context, int width, int height) {
  if (width < 1 || height < 1 || width > kLongestSide || height > kLongestSide) return nullptr;
  const std::size_t bytes = 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (bytes > kMostBytes) return nullptr;
  auto& picture = *static_cast<Picture*>(context);
  try {
    picture = {width, height, std::vector<std::uint8_t>(bytes)};
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
  return picture.rgba.data();
}

}  // namespace

std::string pictureEndings() {
  return fmt::format("{}", fmt::join(kEndings, ", "));
}

std::optional<Diagnostic> whyNoPicture(const fs::path& path) {
  if (isOneOf(kEndings, lowerEnding(path))) return std::nullopt;
  return diagnose(Code::OutputFormatUnknown,
                  fmt::format("{}; pictures are written as {}", path.string(), pictureEndings()));
}

Result<bool> writePicture(const Picture& picture, const fs::path& path) {
  const std::size_t pixels = static_cast<std::size_t>(std::max(picture.width, 0)) *
                             static_cast<std::size_t>(std::max(picture.height, 0));
  if (pixels == 0 || picture.rgba.size() != pixels * 4) {
    return diagnose(Code::OutputUnwritable, "picture without pixels", {}, path.string());
  }
  if (auto why = whyNoPicture(path)) return *why;
  const PictureModule& module = pictureModule();
  if (!module.write || !module.canWrite) return diagnose(Code::Internal, "picture module: " + module.error);
  if (!module.canWrite(path.extension().c_str())) {
    return diagnose(Code::OutputFormatUnknown, "the installed OpenImageIO has none", {}, path.string());
  }
  try {
    AtomicFile file(path);
    const char* error =
        module.write(file.temporaryPath().c_str(), picture.width, picture.height, picture.rgba.data());
    if (error) return diagnose(Code::OutputUnwritable, error, {}, path.string());
    file.commit();
  } catch (const std::system_error& error) {
    return outputFailure(error, path);
  }
  return true;
}

Result<Picture> decodePicture(std::string_view bytes, const std::string& name) {
  const auto failure = [&](const std::string& why) {
    return diagnose(Code::PictureUnreadable, why, {}, name);
  };
  const std::string format(formatOf(bytes, name));
  if (format.empty()) return failure("it is none of PNG, JPEG, TIFF, WebP, BMP, PPM and TGA");
  if (const std::string why = whyBrokenPng(bytes); !why.empty()) return failure(why);
  const PictureModule& module = pictureModule();
  if (!module.read) return diagnose(Code::Internal, "picture module: " + module.error);
  const LodestonePictureFile file{format.c_str(), name.c_str(),
                                  reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()};
  Picture picture;
  const char* message = "";
  switch (module.read(&file, roomIn, &picture, &message)) {
    case kLodestoneWhole:
      return picture;
    case kLodestoneDamaged:
      return {std::move(picture), {diagnose(Code::InputReadInPart, inOneLine(message), {}, name)}};
    case kLodestoneFailed:
      break;
  }
  return failure(inOneLine(message));
}

bool isPicturePath(const fs::path& path) {
  const std::string ending = lowerEnding(path);
  return isOneOf(kEndings, ending) || isOneOf(kReadEndings, ending);
}

Result<Picture> readPicture(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return diagnose(Code::FileNotFound, path.string());
  if (!fs::is_regular_file(path, error)) return diagnose(Code::FileUnreadable, path.string());
  if (fs::file_size(path, error) > kMostBytes)
    return diagnose(Code::PictureUnreadable, "the file is larger than 512 MiB", {}, path.string());
  try {
    return decodePicture(readWholeFile(path), path.string());
  } catch (const std::system_error& unreadable) {
    return diagnose(Code::FileUnreadable, unreadable.what(), {}, path.string());
  }
}

}  // namespace lodestone
