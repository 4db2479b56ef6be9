// Colours of a texture at points of a triangle.
#pragma once

#include <array>

#include "algorithms/rendering/model_look.h"
#include "model/geometry.h"

namespace lodestone {

/// The smaller copies of a picture (rows from the bottom, RGBA, sRGB): means in linear light, down to one
/// texel.
[[nodiscard]] TexturePyramid makePyramid(TexturePyramid::Level image, TextureWrap wrap);

/// How an image lies on a triangle.
class TextureMap {
 public:
  /// `image` outlives this. A triangle without area takes the colour at its first corner.
  TextureMap(const TexturePyramid& image, const std::array<Vec3f, 3>& corners,
             const std::array<Vec2f, 3>& coordinates);

  /// Whether coordinates are such that anything can be sampled: they may be so large that floats overflow.
  [[nodiscard]] bool isFinite() const;

  /// Linear sRGB at a point of the triangle, as the mean over about `size` (a length on the surface): between
  /// texels and between copies of the image linearly. \pre isFinite()
  [[nodiscard]] Vec3f sample(const Vec3f& point, float size) const;

 private:
  const TexturePyramid* image_;
  Vec3f corner_;
  Vec2f coordinate_;
  Vec3f alongS_;  ///< change of s along the surface, per length
  Vec3f alongT_;
  float texels_;  ///< of the full image, per length
};

}  // namespace lodestone
