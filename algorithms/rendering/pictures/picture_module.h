// What the picture module offers. It is loaded when the first picture is read or written, since OpenImageIO
// brings over two hundred shared libraries that `--help` and most commands have no use for.
#pragma once

#include <cstddef>

extern "C" {

/// Whether pictures with this ending (with the dot) can be written.
using LodestoneCanWritePicture = bool (*)(const char* ending);

/// Writes rows from the top of 8-bit RGBA. Null on success, else a text that lives until the next call of the
/// thread.
using LodestoneWritePicture = const char* (*)(const char* path, int width, int height,
                                              const unsigned char* rgba);

/// A picture file in memory, in a format by OpenImageIO's name ("png").
struct LodestonePictureFile {
  const char* format;
  const char* name;  ///< for messages
  const unsigned char* bytes;
  std::size_t size;
};

enum LodestoneReading {
  kLodestoneWhole,
  kLodestoneDamaged,  ///< the pixels are what could be decoded
  kLodestoneFailed,
};

/// Room for so many rows of 8-bit RGBA; null where the picture is too large.
using LodestoneRoom = unsigned char* (*)(void* context, int width, int height);

/// Decodes into the room that `room` makes, rows from the top, colours not multiplied by alpha. `message`
/// says what is wrong where something is, until the next call of the thread.
using LodestoneReadPicture = LodestoneReading (*)(const LodestonePictureFile* file, LodestoneRoom room,
                                                  void* context, const char** message);
}
