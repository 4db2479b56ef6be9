// Surfaces as their model has them: textures, colours of materials.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <vtkSmartPointer.h>

#include "gui/view3d/palette.h"
#include "model/component_mesh.h"

class vtkActor;
class vtkRenderer;

namespace lodestone {

/// Rows from the bottom, RGBA.
struct SurfaceImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// What the surfaces of a city look like.
struct SurfaceLook {
  std::vector<std::shared_ptr<const SurfaceImage>> textures;  ///< by texture; null: not to be had
  std::vector<Rgb> materials;
};

/// Colours for the triangles of one mesh, in place of its look.
struct PaintedTriangles {
  std::shared_ptr<const ComponentMesh> mesh;
  std::vector<Rgb> colours;  ///< of each triangle
};

/// The triangles of a mesh in a renderer. They lie a hair behind what is drawn in the same place.
class SurfaceOverlay {
 public:
  explicit SurfaceOverlay(vtkRenderer* renderer);
  ~SurfaceOverlay();
  SurfaceOverlay(const SurfaceOverlay&) = delete;
  SurfaceOverlay& operator=(const SurfaceOverlay&) = delete;

  /// Draws the components that `drawn` says, painted where `painted` is of `mesh`, else as they look; nothing
  /// where `mesh` is null, or both others are. Cost: linear where any of the four is another than before.
  void show(const std::shared_ptr<const ComponentMesh>& mesh, const std::vector<bool>& drawn,
            const std::shared_ptr<const SurfaceLook>& look,
            const std::shared_ptr<const PaintedTriangles>& painted);

 private:
  void clear();
  void addActor(const std::vector<std::uint32_t>& triangles,
                const std::shared_ptr<const SurfaceImage>& image);
  [[nodiscard]] Rgb colourOf(std::uint32_t triangle) const;

  vtkSmartPointer<vtkRenderer> renderer_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
  std::shared_ptr<const ComponentMesh> mesh_;
  std::shared_ptr<const SurfaceLook> look_;
  std::shared_ptr<const PaintedTriangles> painted_;
  std::vector<bool> drawn_;
};

}  // namespace lodestone
