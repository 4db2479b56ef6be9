// Objects of a level as glTF primitives: vertex data by material, y up.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "model/lod_chain.h"

namespace lodestone {

/// What surfaces share that are drawn alike. Without source material or texture, the role and the kind of
/// surface tell.
struct GlbMaterialKey {
  DrawRole role = DrawRole::Building;
  SurfaceType type = SurfaceType::Wall;
  std::int32_t material = -1;
  std::int32_t texture = -1;
  auto operator<=>(const GlbMaterialKey&) const = default;
};

/// Triangles of one material. Positions are relative to the mesh's origin and already y up.
struct GlbPrimitive {
  GlbMaterialKey material;
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec2f>
      textureCoordinates;       ///< as many as positions where the material has a texture, else none
  std::vector<float> features;  ///< index of the object in its level
  std::vector<std::uint32_t> indices;
  std::uint32_t featureCount = 0;  ///< different ones
};

struct GlbMesh {
  Vec3 origin = Vec3::Zero();  ///< z up, in the level's coordinates: whole metres
  std::vector<GlbPrimitive> primitives;
};

/// The mesh of some objects, primitives in the order of their keys. `usableTextures[t]` says whether texture
/// t can be shown. Vertices are shared within a surface; normals are flat. Objects without triangles add
/// nothing.
[[nodiscard]] GlbMesh makeGlbMesh(std::span<const LevelObject> objects, std::size_t firstFeature,
                                  const std::vector<bool>& usableTextures);

}  // namespace lodestone
