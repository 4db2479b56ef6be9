// Pictures ray cast on the CPU (Embree): no display, no driver, the same pixels everywhere.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/camera.h"
#include "model/lod_chain.h"
#include "model/progress.h"
#include "model/result.h"

namespace lodestone {

/// Rows from the top, 8-bit RGBA.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Lit, anti-aliased (2 × 2 samples a pixel) picture of one level: buildings, clusters and landmarks in their
/// own tints (model/level_colours.h), afternoon sun with shadows, sky and ground. The same pixels for any
/// number of threads. Cost: a few seconds for 370,000 buildings. \throw Cancelled
[[nodiscard]] Picture renderLevel(const LodLevel& level, const Camera& camera, const Progress& progress = {});

/// Box around all geometry of a level.
[[nodiscard]] Box3 bounds(const LodLevel& level);

/// ".png, .jpg, …": what writePicture() writes, for people.
[[nodiscard]] std::string pictureEndings();
/// Why a path cannot take a picture (OutputFormatUnknown), nothing where its ending is one of these.
[[nodiscard]] std::optional<Diagnostic> whyNoPicture(const std::filesystem::path& path);

/// Writes the picture, whole or not at all; the format follows the ending. By a module that is loaded here
/// and no sooner: OpenImageIO would load 267 shared libraries into every start of the command line.
[[nodiscard]] Result<bool> writePicture(const Picture& picture, const std::filesystem::path& path);

/// The picture in the bytes of a file: PNG, JPEG, TIFF, WebP, BMP, PPM and PGM, known by how they begin, and
/// TGA, known by the ending of `name`. Eight bits a channel whatever it had, grey and palettes spread, alpha
/// 255 where there is none, colours not multiplied by alpha; of several pictures the first. Refused
/// (PictureUnreadable): over 32768 pixels on a side or 512 MiB of pixels. What could be decoded of a damaged
/// JPEG comes with InputReadInPart. By the same module. Safe to call from several threads.
[[nodiscard]] Result<Picture> decodePicture(std::string_view bytes, const std::string& name);
/// Whether a path ends as the files do that decodePicture() takes.
[[nodiscard]] bool isPicturePath(const std::filesystem::path& path);
/// decodePicture() of a file.
[[nodiscard]] Result<Picture> readPicture(const std::filesystem::path& path);

}  // namespace lodestone
