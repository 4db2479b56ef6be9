// Polygon files (PLY), ASCII and binary. assimp's reader crashes or never ends on files that are cut off.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

/// Vertices and faces of a PLY file, as they stand in it; other elements and properties are skipped.
struct PlyMesh {
  std::vector<Vec3> vertices;
  std::vector<Vec2f> vertexCoordinates;  ///< texture coordinates by vertex; empty where there are none
  /// Corners of face f: corners[faceStart[f] … faceStart[f + 1]). Not checked against the vertices.
  std::vector<std::uint32_t> faceStart{0};
  std::vector<std::uint32_t> corners;
  std::vector<Vec2f> cornerCoordinates;  ///< texture coordinates by corner; empty where there are none
  std::string texture;                   ///< of "comment TextureFile"
};

/// Cost: linear; memory is bounded by the size of `bytes`, whatever counts its header claims.
/// \throw std::runtime_error when the header is not understood, std::length_error when the file ends early.
[[nodiscard]] PlyMesh parsePly(std::string_view bytes);

}  // namespace lodestone
