// Objects of a level as OBJ text.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/lod_chain.h"

namespace lodestone {

/// Name of a material in the MTL file: of a texture, of a source material, or of a role and a kind of
/// surface.
[[nodiscard]] std::string objMaterialName(DrawRole role, const SurfaceInfo& surface, bool textured);

/// How many v and vt lines came before: OBJ counts from the beginning of the file.
struct ObjOffsets {
  std::size_t vertices = 0;
  std::size_t coordinates = 0;
};

struct ObjText {
  std::string text;
  /// The materials used, by name, each with one surface that has it.
  struct Use {
    DrawRole role;
    SurfaceInfo surface;
    bool textured;
  };
  std::map<std::string, Use> materials;
};

/// What the objects will add to the offsets.
[[nodiscard]] ObjOffsets objSizes(std::span<const LevelObject> objects);
[[nodiscard]] ObjText makeObjText(std::span<const LevelObject> objects, const CityModel* city,
                                  const ObjOffsets& before, const std::vector<bool>& usableTextures);
/// A name as one word of an OBJ line: white space, control characters and '%' as %XX.
[[nodiscard]] std::string objName(std::string_view name);

}  // namespace lodestone
