// What `perceive` says of views and triangles, as JSON (resources/schemas/perception.json and views.json).
#pragma once

#include <filesystem>
#include <span>

#include "model/component_mesh.h"
#include "model/perception.h"

namespace lodestone {

/// The class of each triangle that was seen (glimpsed: with no pixels), and which were not. Triangles are counted in the order of
/// `mesh`, and named by component and source object. Whole or not at all. \throw std::system_error
void writePerceivedTriangles(const ComponentMesh& mesh, const Perception& perception,
                             const std::filesystem::path& path);

/// Cameras (as they are given here: in coordinates that mean something outside), the display, the classes'
/// Gaussians and thresholds. Whole or not at all. \throw std::system_error
void writePerceivedViews(const Perception& perception, std::span<const Camera> cameras,
                         const std::filesystem::path& path);

}  // namespace lodestone
