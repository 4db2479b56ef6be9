// Draws a city: geometry is uploaded once, a cut moves index ranges, a selection moves colours.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <vtkProp.h>

#include "gui/view3d/city_mesh.h"
#include "gui/view3d/palette.h"

namespace lodestone {

/// The prop first records node, normal and depth of each pixel in buffers of its own, then paints the picture
/// from them. The first step is left out when neither camera nor geometry changed, so that a hover costs one
/// pass over the picture.
class CityProp : public vtkProp {
 public:
  static CityProp* New();
  vtkTypeMacro(CityProp, vtkProp)

      /// Parts that are drawn from: buildings, clusters, context. Uploaded when first drawn.
      enum Part {
        Buildings,
        Clusters,
        Context,
        PartCount
      };
  void setMesh(Part part, std::shared_ptr<const NodeMesh> mesh);
  /// What is drawn of a part.
  void setRanges(Part part, std::vector<MeshRange> ranges);
  /// One colour a node, by NodeId; alpha says how its outline is marked (kPlain, kHovered, kSelected).
  void setColours(std::vector<std::array<std::uint8_t, 4>> colours);
  static constexpr std::uint8_t kPlain = 0, kHovered = 128, kSelected = 255;
  void setPalette(const Palette& palette);
  void setGround(double height, bool shown, bool grid);
  void setEdges(bool on);
  /// How much buildings and clusters, and everything else, cover the ground behind them: 0–1.
  void setOpacity(float buildings, float context);
  void setPixelRatio(double ratio);
  void setHazeDistance(double metres);

  double* GetBounds() override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  CityProp();
  ~CityProp() override;

 private:
  CityProp(const CityProp&) = delete;
  void operator=(const CityProp&) = delete;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lodestone
