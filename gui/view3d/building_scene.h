// The stage of one building: up to three panes behind one camera, beside each other or wiped over each other.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "gui/view3d/building_pane.h"
#include "gui/view3d/scene.h"
#include "gui/view3d/scene_camera.h"

namespace lodestone {

enum class PaneLayout {
  Side,  ///< each pane a part of the width, all with the same camera
  Wipe   ///< the first two panes over each other, parted at a line
};

/// What stands under a pixel. Component and vertex are the original's.
struct PickedPart {
  std::size_t pane = 0;
  std::uint32_t component = kNoNode;
  std::optional<std::uint32_t> vertex;  ///< where one is near
  Vec3 point = Vec3::Zero();
};

class BuildingScene : public Scene {
 public:
  static constexpr std::size_t kPanes = 3;

  /// \pre kPanes renderers of one window.
  explicit BuildingScene(const std::vector<vtkSmartPointer<vtkRenderer>>& renderers);
  ~BuildingScene() override;

  /// What one pane shows; null empties it. The camera stays; call fit() for another building.
  void setModel(std::size_t pane, std::shared_ptr<const PaneModel> model);
  [[nodiscard]] std::shared_ptr<const PaneModel> model(std::size_t pane) const;
  void setContacts(std::size_t pane, const std::vector<ContactMark>& marks);
  /// The buildings around, in every pane, grey until targets are told; null: none.
  void setSurroundings(std::shared_ptr<const Surroundings> around);
  [[nodiscard]] const std::shared_ptr<const Surroundings>& surroundings() const { return around_; }
  /// What is seen past the model of a pane, by place in the surroundings.
  void setTargets(std::size_t pane, std::vector<TargetFate> fates);
  /// Marks a building around.
  void setChosenTarget(std::optional<std::size_t> target);
  /// The viewpoint that is drawn in every pane.
  void setSight(const std::optional<SightOptions>& sight);
  [[nodiscard]] const std::optional<SightOptions>& sight() const { return sight_; }
  /// Shows these panes, from left to right; of Wipe two. \pre 1 to kPanes different ones.
  void setLayout(PaneLayout layout, std::vector<std::size_t> panes);
  [[nodiscard]] const std::vector<std::size_t>& panes() const { return shown_; }
  [[nodiscard]] PaneLayout layout() const { return layout_; }
  /// Where the line of Wipe stands: 0 at the left, 1 at the right.
  void setWipe(double share);
  [[nodiscard]] double wipe() const { return wipe_; }

  void setLook(const BuildingLook& look);
  [[nodiscard]] const BuildingLook& look() const { return look_; }
  /// What changes as the pointer moves: cheaper than a new look.
  void setHover(std::uint32_t component);

  /// Exact for components; a vertex is one of the pane's within `reach` pixels that is not hidden.
  [[nodiscard]] std::optional<PickedPart> pick(double x, double y, double reach = 0) const;
  /// Place in the surroundings of the building that is drawn at a pixel; nothing where something else is.
  [[nodiscard]] std::optional<std::size_t> pickTarget(double x, double y) const;
  /// The pane at a pixel.
  [[nodiscard]] std::size_t paneAt(double x) const { return shown_[placeAt(x)]; }
  /// The ray of a shown pane through a pixel that may lie beside it.
  [[nodiscard]] Ray through(std::size_t pane, double x, double y) const;
  /// Device pixel of a point in one of the shown panes; nothing behind the eye or beside the pane.
  [[nodiscard]] std::optional<Vec2> project(std::size_t pane, const Vec3& point) const;
  /// Left and right end of a shown pane, device pixels.
  [[nodiscard]] std::pair<double, double> spanOf(std::size_t pane) const;

  void setSize(int width, int height, double pixelRatio = 1) override;
  void setJitter(double x, double y) override;
  [[nodiscard]] const Camera& camera() const override { return camera_.camera(); }
  void setCamera(const Camera& camera) override;
  /// Looks at the building; when it does so already, at all that is drawn around it.
  void fit() override;
  void fitTo(const Box3& box) override;
  void setPlanView(bool plan) override;
  [[nodiscard]] bool planView() const override { return camera_.plan(); }
  [[nodiscard]] CameraLimits limits() const override;
  [[nodiscard]] Ray through(double x, double y) const override;
  [[nodiscard]] std::optional<Vec3> groundPoint(double x, double y) const override;
  [[nodiscard]] Box3 bounds() const override { return bounds_; }
  [[nodiscard]] double groundHeight() const override { return bounds_.empty() ? 0 : bounds_.min.z(); }
  void onChange(std::function<void()> changed) override { changed_ = std::move(changed); }

 private:
  [[nodiscard]] std::size_t placeAt(double x) const;
  [[nodiscard]] std::size_t placeOf(std::size_t pane) const;
  [[nodiscard]] std::pair<double, double> span(std::size_t place) const;
  [[nodiscard]] std::optional<std::uint32_t> vertexNear(const PaneModel& model, std::size_t pane,
                                                        const Vec2& at, double reach, double depth) const;
  [[nodiscard]] Box3 everything() const;
  void arrange();
  void aim(vtkRenderer& renderer, std::size_t place) const;
  void beforeFrame();

  std::array<std::unique_ptr<BuildingPane>, kPanes> panes_;
  std::vector<std::size_t> shown_{0};
  PaneLayout layout_ = PaneLayout::Side;
  double wipe_ = 0.5;
  BuildingLook look_;
  Box3 bounds_;
  std::shared_ptr<const Surroundings> around_;
  std::optional<SightOptions> sight_;
  SceneCamera camera_;
  Vec2 jitter_ = Vec2::Zero();
  int width_ = 1;
  int height_ = 1;
  std::function<void()> changed_ = [] {};
  std::array<unsigned long, kPanes> startTags_{};
};

}  // namespace lodestone
