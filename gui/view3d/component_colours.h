// Colours of components, vertex classes and angles: told apart by people with any colour vision.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "gui/view3d/palette.h"
#include "model/component_mesh.h"
#include "model/simplify_report.h"

namespace lodestone {

/// A colour for each component, such that two that touch differ as long as twelve hues allow it. Cost:
/// linear.
[[nodiscard]] std::vector<Rgb> componentColours(
    std::size_t count, std::span<const std::pair<std::uint32_t, std::uint32_t>> contacts);

/// Of an E–C angle, 0–90°: dark blue where the edge lies in the plane, by violet to orange where it stands
/// across.
[[nodiscard]] Rgb angleColour(double degrees);
[[nodiscard]] Rgb classColour(VertexClass vertexClass);
[[nodiscard]] Rgb fateColour(ContactFate fate);

}  // namespace lodestone
