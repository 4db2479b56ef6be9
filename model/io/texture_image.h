// The image of a texture: a file of its own, or bytes that came inside the input.
#pragma once

#include <cstddef>
#include <string>

#include "model/city_model.h"

namespace lodestone {

[[nodiscard]] bool hasImage(const Texture& texture);
/// Its first bytes, up to `count`; fewer, or none, where it cannot be read.
[[nodiscard]] std::string readImageHead(const Texture& texture, std::size_t count);
/// The whole image file. \throw std::runtime_error where it cannot be read
[[nodiscard]] std::string readImage(const Texture& texture);

}  // namespace lodestone
