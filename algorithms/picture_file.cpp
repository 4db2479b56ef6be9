#include <cerrno>
#include <csetjmp>
#include <system_error>

#include <png.h>

#include "algorithms/rendering.h"
#include "model/io/atomic_file.h"

namespace lodestone {
namespace {

/// What libpng's callbacks see.
void writeBytes(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::ostream*>(png_get_io_ptr(png))
      ->write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
}
void flushBytes(png_structp /*png*/) {}

/// False when libpng gives up. No object with a destructor lives in here, since libpng leaves by longjmp.
bool encodePng(png_structp png, png_infop info, const Picture& picture, std::ostream* out) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, out, writeBytes, flushBytes);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
               8, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  const std::size_t stride = static_cast<std::size_t>(picture.width) * 4;
  for (int y = 0; y < picture.height; ++y) {
    png_write_row(png, picture.rgba.data() + static_cast<std::size_t>(y) * stride);
  }
  png_write_end(png, info);
  return true;
}

bool writePng(const Picture& picture, std::ostream& out) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool written = info && encodePng(png, info, picture, &out);
  png_destroy_write_struct(&png, &info);
  return written;
}

}  // namespace

Result<bool> writePicture(const Picture& picture, const std::filesystem::path& path) {
  if (path.extension() != ".png" && path.extension() != ".PNG") {
    return diagnose(Code::OutputFormatUnknown, "pictures are written as PNG", {}, path.string());
  }
  const std::size_t pixels = static_cast<std::size_t>(std::max(picture.width, 0)) *
                             static_cast<std::size_t>(std::max(picture.height, 0));
  if (pixels == 0 || picture.rgba.size() != pixels * 4) {
    return diagnose(Code::OutputUnwritable, "picture without pixels", {}, path.string());
  }
  try {
    AtomicFile file(path);
    if (!writePng(picture, file.stream()))
      return diagnose(Code::OutputUnwritable, "PNG encoder failed", {}, path.string());
    file.commit();
  } catch (const std::system_error& error) {
    const bool full = error.code() == std::errc::no_space_on_device;
    return diagnose(full ? Code::OutputDiskFull : Code::OutputUnwritable, error.what(), {}, path.string());
  }
  return true;
}

}  // namespace lodestone
