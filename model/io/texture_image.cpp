#include "model/io/texture_image.h"

#include "model/io/input_file.h"

namespace lodestone {

bool hasImage(const Texture& texture) {
  return texture.embedded || (!texture.missing && fileExists(texture.path));
}

std::string readImageHead(const Texture& texture, std::size_t count) {
  if (texture.embedded) return texture.embedded->substr(0, count);
  return texture.missing ? std::string() : readHead(texture.path, count);
}

std::string readImage(const Texture& texture) {
  return texture.embedded ? *texture.embedded : readWholeFile(texture.path);
}

}  // namespace lodestone
