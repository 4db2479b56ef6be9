// Components and vertex classes as JSON.
#pragma once

#include <filesystem>
#include <span>

#include "model/component_mesh.h"

namespace lodestone {

/// `{"type": "classification", …}` of resources/docs/command-line.md. `positions` are those of the mesh's
/// vertices in the frame that is to be written; angles in degrees. Written whole or not at all. \throw
/// std::system_error
void writeClassification(const ComponentMesh& mesh, const Classification& classes,
                         std::span<const Vec3> positions, const std::filesystem::path& path);

}  // namespace lodestone
