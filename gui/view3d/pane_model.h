// A building's components as one pane of the stage draws them. Made on any thread, shared without locks.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gui/view3d/city_mesh.h"
#include "gui/view3d/overlays.h"
#include "model/component_mesh.h"

namespace lodestone {

/// Components are numbered as in the original, in every pane: those that are gone have nothing to draw.
struct PaneModel {
  std::shared_ptr<const ComponentMesh> mesh;
  std::vector<std::uint32_t> component;       ///< of the original, by component of `mesh`
  std::vector<std::uint32_t> vertex;          ///< of the original, by vertex of `mesh`
  std::shared_ptr<const NodeMesh> nodes;      ///< node i is component i of the original
  std::vector<VertexClass> classes;           ///< by vertex of `mesh`
  std::vector<std::array<Vec3, 2>> creases;   ///< where faces bend or end, component by component
  std::vector<std::uint32_t> creaseStart{0};  ///< by component of the original, and the end of the last
  LineSegments angles;                        ///< boundary edges in the colours of their E–C angles
  std::vector<std::uint32_t> angleComponent;  ///< of the original, by segment of `angles`
};

/// The original with its classes; null classes: none known yet.
[[nodiscard]] std::shared_ptr<const PaneModel> makePaneModel(std::shared_ptr<const ComponentMesh> mesh,
                                                             const Classification* classes);
/// A simplified version of `original`: `component` and `vertex` say what stands for what.
[[nodiscard]] std::shared_ptr<const PaneModel> makePaneModel(std::shared_ptr<const ComponentMesh> mesh,
                                                             std::vector<std::uint32_t> component,
                                                             std::vector<std::uint32_t> vertex,
                                                             const PaneModel& original);

}  // namespace lodestone
