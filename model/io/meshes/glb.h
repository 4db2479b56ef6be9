// Binary glTF 2.0.
#pragma once

#include "model/io/format.h"

namespace lodestone {

/// One file a level: `path` itself for one level, "name_level-K.glb" beside it for several (WriteReport lists
/// them).
///
/// Metres, y up: x east, y up, z south, in the frame of the model. Every 512 objects make a mesh, whose
/// node's translation keeps its coordinates small. Every object of the level is a feature (EXT_mesh_features,
/// attribute _FEATURE_ID_0), and a row of the property table (EXT_structural_metadata): id, role, node,
/// level, the ids of its source buildings, base, height, negative space, and the commonest attributes of the
/// buildings. Materials are the source's, with PNG and JPEG textures embedded, else by role and kind of
/// surface. asset.extras.lodestone holds the CRS and the origin that bring coordinates back to the world (see
/// Crs), the level's figures and the recipe.
///
/// The same bytes for any number of threads; memory follows 512 objects and the property table, not the city.
[[nodiscard]] Format glbFormat();

}  // namespace lodestone
