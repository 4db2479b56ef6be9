// Pictures ray cast on the CPU (Embree): no display, no driver, the same pixels everywhere.
#pragma once

#include <cstdint>
#include <filesystem>
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

/// Writes PNG, whole or not at all. By libpng alone: OpenImageIO would load 267 shared libraries into every
/// start of the command line.
[[nodiscard]] Result<bool> writePicture(const Picture& picture, const std::filesystem::path& path);

}  // namespace lodestone
