#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <system_error>

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "algorithms/rendering/pictures/picture_module.h"
#include "algorithms/rendering/rendering.h"
#include "model/io/atomic_file.h"
#include "model/io/output_failure.h"

namespace lodestone {
namespace fs = std::filesystem;
namespace {

constexpr const char* kModule = "lib/lodestone/lodestone_pictures.so";

/// The loaded module; it stays until the program ends.
struct PictureModule {
  LodestoneCanWritePicture canWrite = nullptr;
  LodestoneWritePicture write = nullptr;
  std::string error;
};

/// lib/lodestone beside or above the program's folder: where it is installed, and in a build folder, wherever
/// that has been moved to.
PictureModule loadModule() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  PictureModule module{nullptr, nullptr, "no lib/lodestone/lodestone_pictures.so above " + program.string()};
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
  return module;
}

const PictureModule& pictureModule() {
  static const PictureModule module = loadModule();
  return module;
}

// With eight bits a channel and without a palette.
constexpr std::array<std::string_view, 7> kEndings{".png", ".jpg", ".jpeg", ".tif", ".tiff", ".webp", ".bmp"};

}  // namespace

std::string pictureEndings() {
  return fmt::format("{}", fmt::join(kEndings, ", "));
}

std::optional<Diagnostic> whyNoPicture(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end()) return std::nullopt;
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

}  // namespace lodestone
