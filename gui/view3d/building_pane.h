// One picture of a building's components: the original, or what a method made of it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "gui/view3d/city_prop.h"
#include "gui/view3d/overlays.h"
#include "gui/view3d/pane_model.h"
#include "gui/view3d/point_overlay.h"
#include "gui/view3d/sight_overlay.h"
#include "gui/view3d/surface_overlay.h"
#include "gui/view3d/surroundings.h"
#include "model/simplify_report.h"

namespace lodestone {

/// What all panes of a stage show alike. Components and vertices are the original's.
struct BuildingLook {
  std::vector<Rgb> colours;                     ///< of each component
  bool colourComponents = true;                 ///< else all look alike
  std::shared_ptr<const SurfaceLook> surfaces;  ///< instead of colours; null: none
  /// Instead of both, in the panes that show their meshes.
  std::vector<std::shared_ptr<const PaintedTriangles>> painted;
  std::array<bool, 3> glyphs{};         ///< by VertexClass
  bool angles = false;                  ///< boundary edges by E–C angle
  bool ghosts = true;                   ///< lines of what is not isolated
  std::vector<bool> isolated;           ///< of each component; empty: all are drawn
  std::vector<std::uint32_t> selected;  ///< components
  std::uint32_t hover = kNoNode;
  std::optional<std::size_t> target;        ///< a building around that is marked
  std::optional<Vec3> picked;               ///< a vertex that is asked about
  std::vector<std::array<Vec3, 3>> planes;  ///< its reference planes' triangles
  Palette palette = lightPalette();
  bool dark = false;
};

/// A contact that is marked.
struct ContactMark {
  Vec3 at = Vec3::Zero();
  ContactFate fate = ContactFate::Separated;
  bool chosen = false;
};

class BuildingPane {
 public:
  explicit BuildingPane(vtkRenderer* renderer);
  ~BuildingPane();
  BuildingPane(const BuildingPane&) = delete;
  BuildingPane& operator=(const BuildingPane&) = delete;

  void setModel(std::shared_ptr<const PaneModel> model, const BuildingLook& look);
  [[nodiscard]] const std::shared_ptr<const PaneModel>& model() const { return model_; }
  /// Everything anew. Cost: linear in the vertices that have glyphs.
  void show(const BuildingLook& look);
  /// Selection and hover alone.
  void recolour(const BuildingLook& look);
  void setContacts(const std::vector<ContactMark>& marks);
  /// The buildings around, grey until targets are told; null: none.
  void setSurroundings(std::shared_ptr<const Surroundings> around, const BuildingLook& look);
  void setTargets(std::vector<TargetFate> fates, const BuildingLook& look);
  void setSight(const std::optional<SightOptions>& sight, const Palette& palette);
  void setGround(double height);
  void setPixelRatio(double ratio);

  [[nodiscard]] vtkRenderer& renderer() { return *renderer_; }
  /// Components that are drawn solid.
  [[nodiscard]] const std::vector<NodeId>& solid() const { return solid_; }

 private:
  void showSurfaces(const BuildingLook& look);
  [[nodiscard]] std::shared_ptr<const PaintedTriangles> paintOf(const BuildingLook& look) const;
  void setRanges(const BuildingLook& look);
  void showGlyphs(const BuildingLook& look);
  void showLines(const BuildingLook& look);
  void addCreases(const BuildingLook& look, LineSegments& lines) const;

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<CityProp> prop_;
  std::shared_ptr<const PaneModel> model_;
  std::shared_ptr<const Surroundings> around_;
  std::vector<TargetFate> targets_;  ///< of each building around; those that are missing are unseen
  std::vector<NodeId> solid_;
  LineOverlay ghosts_, angles_, planes_;
  std::array<PointOverlay, 3> glyphs_;
  PointOverlay picked_, separated_, lost_, chosen_;
  SightOverlay sight_;
  SurfaceOverlay surfaces_;
};

}  // namespace lodestone
