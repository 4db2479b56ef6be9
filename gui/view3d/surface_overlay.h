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

/// The triangles of a mesh in a renderer. They lie a hair behind what is drawn in the same place.
class SurfaceOverlay {
 public:
  explicit SurfaceOverlay(vtkRenderer* renderer);
  ~SurfaceOverlay();
  SurfaceOverlay(const SurfaceOverlay&) = delete;
  SurfaceOverlay& operator=(const SurfaceOverlay&) = delete;

  /// Draws the components that `drawn` says; nothing where `look` or `mesh` is null. Cost: linear where any
  /// of the three is another than before.
  void show(const std::shared_ptr<const ComponentMesh>& mesh, const std::vector<bool>& drawn,
            const std::shared_ptr<const SurfaceLook>& look);

 private:
  void clear();
  void addActor(const std::vector<std::uint32_t>& triangles,
                const std::shared_ptr<const SurfaceImage>& image);

  vtkSmartPointer<vtkRenderer> renderer_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
  std::shared_ptr<const ComponentMesh> mesh_;
  std::shared_ptr<const SurfaceLook> look_;
  std::vector<bool> drawn_;
};

}  // namespace lodestone
