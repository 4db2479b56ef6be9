// Wavefront OBJ with MTL.
#pragma once

#include "model/io/format.h"

namespace lodestone {

/// One file a level: `path` itself for one level, "name_level-K.obj" beside it for several (WriteReport lists
/// all files). Beside each, with the same stem: ".mtl", ".offset.json" with the CRS and the offset, and,
/// where there are textures, a folder "_textures" with copies of the images, named by relative paths.
///
/// Metres with millimetres, z up (OBJ itself knows no up axis), relative to the offset that the head of the
/// file names: world = offset + v. A group an object, named by its id (white space and control characters as
/// %XX), preceded by a comment with role and source buildings for clusters and landmarks. Walls are quads,
/// everything else triangles.
///
/// The same bytes for any number of threads; memory follows 512 objects.
[[nodiscard]] Format objFormat();

}  // namespace lodestone
