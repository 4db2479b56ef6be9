// Pictures of a model to judge what people perceive of it: lit the same way from everywhere
// (algorithms/rendering/fixed_lights.h), without shadows, before a plain background.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "algorithms/rendering/grey_image.h"
#include "algorithms/rendering/model_look.h"
#include "algorithms/rendering/rendering.h"
#include "model/camera.h"
#include "model/component_mesh.h"
#include "model/progress.h"

namespace lodestone {

/// In pixels that do not show the model.
inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFFU;

struct ModelPicture {
  Picture picture;
  GreyImage grey;                       ///< the luminance of the same picture, not rounded
  std::vector<std::uint32_t> triangle;  ///< the identity picture: what most of a pixel's four samples show
};

/// Surfaces are lit by their triangle's normal on the side that is seen; textures are filtered by the size of
/// a pixel on the surface. Where surfaces lie in one place the triangle of the highest index is seen.
class ModelRenderer {
 public:
  /// `look` may be null: everything is grey. \throw std::runtime_error when Embree cannot build the scene
  ModelRenderer(const ComponentMesh& mesh, std::shared_ptr<const ModelLook> look);
  ~ModelRenderer();
  ModelRenderer(ModelRenderer&&) noexcept;
  ModelRenderer& operator=(ModelRenderer&&) noexcept;

  /// 2 × 2 samples a pixel, in parallel over rows, the same pixels for any number of threads. Safe to call
  /// from several threads. Cost: O(pixels · log triangles). \throw Cancelled
  [[nodiscard]] ModelPicture render(const Camera& camera, const Progress& progress = {}) const;
  [[nodiscard]] std::uint32_t triangleCount() const;

  /// Whether some of four points of a triangle, its middle and one near each corner, is in sight of one of
  /// the eyes from either side; false for triangles that are not asked for. In parallel. Cost: at most 4 rays
  /// an eye and triangle that is asked for. \throw Cancelled
  [[nodiscard]] std::vector<bool> visibleFrom(const std::vector<Vec3>& eyes, const std::vector<bool>& asked,
                                              const Progress& progress = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lodestone
