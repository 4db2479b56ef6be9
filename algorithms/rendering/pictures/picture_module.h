// What the picture module offers. It is loaded when the first picture is written, since OpenImageIO brings
// over two hundred shared libraries that `--help` and most commands have no use for.
#pragma once

extern "C" {

/// Whether pictures with this ending (with the dot) can be written.
using LodestoneCanWritePicture = bool (*)(const char* ending);

/// Writes rows from the top of 8-bit RGBA. Null on success, else a text that lives until the next call of the
/// thread.
using LodestoneWritePicture = const char* (*)(const char* path, int width, int height,
                                              const unsigned char* rgba);
}
