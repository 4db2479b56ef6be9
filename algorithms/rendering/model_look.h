// What the surfaces of a city look like, decoded for ray casting.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/city_model.h"
#include "model/component_mesh.h"
#include "model/diagnostics.h"
#include "model/progress.h"

namespace lodestone {

/// What is shown beyond 0–1.
enum class TextureWrap { Repeat, Mirror, Clamp };

/// An image and its smaller copies, each half as large as the one before, down to one texel.
struct TexturePyramid {
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  ///< rows from the bottom, as texture coordinates count
  };
  std::vector<Level> levels;
  TextureWrap wrap = TextureWrap::Repeat;
};

struct ModelLook {
  std::vector<std::shared_ptr<const TexturePyramid>> textures;  ///< by texture; null: not to be had
  std::vector<std::array<float, 3>> materials;                  ///< sRGB
};

/// The look of the surfaces of `mesh`, made of buildings of `city`: images that none of them shows are not
/// read. Surfaces whose image is missing (the import has told of it) or cannot be decoded (Code::TextureBad)
/// take their material, or grey. \throw Cancelled
[[nodiscard]] std::shared_ptr<const ModelLook> readModelLook(const CityModel& city, const ComponentMesh& mesh,
                                                             Diagnostics* diagnostics = nullptr,
                                                             const Progress& progress = {});

}  // namespace lodestone
