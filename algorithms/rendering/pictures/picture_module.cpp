#include "algorithms/rendering/pictures/picture_module.h"

#include <algorithm>
#include <exception>
#include <string>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace {

/// What the first channels of a picture are, and how they become RGBA.
struct Channels {
  int count = 0;            ///< those that are read, at most 4
  bool alpha = false;       ///< the last of them is alpha
  bool multiplied = false;  ///< the colours have been multiplied by it
};

Channels channelsOf(const OIIO::ImageSpec& spec, const std::string& format) {
  Channels channels;
  channels.count = std::min(spec.nchannels, 4);
  channels.alpha = channels.count % 2 == 0 && spec.alpha_channel == channels.count - 1;
  // The reader of BMP says nothing of alpha and leaves the colours alone.
  channels.multiplied =
      channels.alpha && format != "bmp" && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
  return channels;
}

/// The channels as they were read, spread over the four of a pixel.
void makeRgba(const Channels& channels, unsigned char* pixel) {
  if (channels.count <= 2) {
    pixel[3] = channels.alpha ? pixel[1] : 255;
    pixel[1] = pixel[2] = pixel[0];
  } else if (!channels.alpha) {
    pixel[3] = 255;
  }
  if (!channels.multiplied || pixel[3] == 0 || pixel[3] == 255) return;
  for (int c = 0; c < 3; ++c)
    pixel[c] = static_cast<unsigned char>(std::min(255, (pixel[c] * 255 + pixel[3] / 2) / pixel[3]));
}

LodestoneReading readPicture(const LodestonePictureFile& file, LodestoneRoom room, void* context,
                             std::string& message) {
  const auto in = OIIO::ImageInput::create(file.format);
  if (!in || !in->supports("ioproxy")) {
    message = in ? "the installed OpenImageIO reads it from files only" : OIIO::geterror();
    return kLodestoneFailed;
  }
  OIIO::Filesystem::IOMemReader memory(file.bytes, file.size);
  OIIO::ImageSpec spec;
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);
  if (!in->set_ioproxy(&memory) || !in->open(file.name, spec, wishes)) {
    message = in->geterror();
    return kLodestoneFailed;
  }
  unsigned char* rgba = spec.nchannels > 0 ? room(context, spec.width, spec.height) : nullptr;
  if (!rgba) {
    message = "it has " + std::to_string(spec.width) + " × " + std::to_string(spec.height) + " pixels";
    return kLodestoneFailed;
  }
  const Channels channels = channelsOf(spec, file.format);
  const bool read = in->read_image(0, 0, 0, channels.count, OIIO::TypeDesc::UINT8, rgba, 4);
  message = in->geterror();
  if (!read) return kLodestoneFailed;
  const std::size_t pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  for (std::size_t i = 0; i < pixels; ++i) makeRgba(channels, rgba + 4 * i);
  return message.empty() ? kLodestoneWhole : kLodestoneDamaged;
}

}  // namespace

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

extern "C" LodestoneReading lodestoneReadPicture(const LodestonePictureFile* file, LodestoneRoom room,
                                                 void* context, const char** message) {
  thread_local std::string text;
  LodestoneReading reading = kLodestoneFailed;
  text.clear();
  try {
    reading = readPicture(*file, room, context, text);
  } catch (const std::exception& error) {  // nothing is thrown across the module's edge
    text = error.what();
  }
  *message = text.c_str();
  return reading;
}

// The module's functions must be of the types that its users load them as.
static const LodestoneCanWritePicture kCanWrite [[maybe_unused]] = lodestoneCanWritePicture;
static const LodestoneWritePicture kWrite [[maybe_unused]] = lodestoneWritePicture;
static const LodestoneReadPicture kRead [[maybe_unused]] = lodestoneReadPicture;
