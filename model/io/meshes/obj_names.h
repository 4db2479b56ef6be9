// Names with spaces in OBJ files.
#pragma once

#include <cstddef>
#include <string>

#include <assimp/DefaultIOSystem.h>

namespace lodestone {

/// assimp ends the name of an object or group at its first space, and makes one of those that then agree.
/// Here spaces within such names come to it as another sign, which takeNameBack() turns back.
class ObjNames : public Assimp::DefaultIOSystem {
 public:
  Assimp::IOStream* Open(const char* file, const char* mode) override;
};

[[nodiscard]] std::string takeNameBack(std::string name);

}  // namespace lodestone
