#include "algorithms/rendering/pictures/picture_module.h"

#include <string>

#include <OpenImageIO/imageio.h>

extern "C" bool lodestoneCanWritePicture(const char* ending) {
  return OIIO::ImageOutput::create(std::string("picture") + ending) != nullptr;
}

extern "C" const char* lodestoneWritePicture(const char* path, int width, int height,
                                             const unsigned char* rgba) {
  thread_local std::string error;
  const auto out = OIIO::ImageOutput::create(path);
  if (!out) {
    error = OIIO::geterror();
    return error.c_str();
  }
  OIIO::ImageSpec spec(width, height, 4, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  const bool written = out->open(path, spec) && out->write_image(OIIO::TypeDesc::UINT8, rgba) && out->close();
  if (written) return nullptr;
  error = out->geterror();
  return error.c_str();
}

// The module's two functions must be of the types that its users load them as.
static const LodestoneCanWritePicture kCanWrite [[maybe_unused]] = lodestoneCanWritePicture;
static const LodestoneWritePicture kWrite [[maybe_unused]] = lodestoneWritePicture;
