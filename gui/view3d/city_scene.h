// What the 3D view shows: one city, its cluster tree and the cut that is drawn. VTK, no Qt.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gui/view3d/palette.h"
#include "gui/view3d/scene.h"
#include "model/city_model.h"
#include "model/cluster_tree.h"

class vtkRenderer;

namespace lodestone {

struct SceneGeometry;

/// What stands under a pixel.
struct PickedNode {
  NodeId node = kNoNode;  ///< building i is node i, also where there is no tree
  DrawRole role = DrawRole::Building;
  NodeId of = kNoNode;        ///< the drawn cluster that a landmark stands in
  Vec3 point = Vec3::Zero();  ///< where the ray meets it, local metres
  double distance = 0;        ///< from the eye, metres
};

/// Parts of the picture that can be switched on and off.
enum class Overlay { Hulls, NegativeSpace, Landmarks, Streets, Ground, Edges };
inline constexpr std::size_t kOverlayCount = 6;

/// What a scene is made of.
enum class SceneLayer {
  Buildings,     ///< with the clusters that stand for them
  Surroundings,  ///< terrain, water, vegetation, bridges, …
  Lines,
};
inline constexpr std::size_t kSceneLayerCount = 3;
struct LayerStyle {
  bool visible = true;
  std::optional<Rgb> colour;  ///< instead of the theme's; of buildings: not of clusters and landmarks
  float opacity = 1;          ///< 0–1, over the ground
  bool operator==(const LayerStyle&) const = default;
};

/// ByRole: buildings, clusters and landmarks in their own tints. ByCluster: each drawn cluster in a stable
/// hue.
enum class SceneColours { ByRole, ByCluster };

/// The contents of one renderer. All calls on the thread that owns it. Geometry is meshed and uploaded once
/// for each city and tree; a cut, a selection and a hover move index ranges and colours only.
class CityScene : public Scene {
 public:
  explicit CityScene(vtkRenderer* renderer);
  ~CityScene() override;

  /// Shows all buildings of `city`: each its finest exterior geometry, or its footprint as a block. `tree`
  /// may be null, and may come later: setting the same city again with a tree keeps what was built, and the
  /// selected buildings. A null city empties the scene. The camera stays; call fit(). `prepared` is what
  /// makeSceneGeometry() made of both on another thread, or null: then it is made here. Cost: below 0.3 s for
  /// 40,000 footprints on two cores, in parallel.
  void setCity(std::shared_ptr<const CityModel> city, std::shared_ptr<const ClusterTree> tree = nullptr,
               std::shared_ptr<const SceneGeometry> prepared = nullptr);
  [[nodiscard]] std::shared_ptr<const CityModel> city() const;
  [[nodiscard]] std::shared_ptr<const ClusterTree> tree() const;
  /// What is built now, to hand to makeSceneGeometry() for the same city; null when empty.
  [[nodiscard]] std::shared_ptr<const SceneGeometry> geometry() const;

  void showAllBuildings();
  /// Draws exactly the nodes of `cut` (of the tree given last). Cost: a few ms for 370,000 nodes.
  void showCut(const Cut& cut);
  /// What is drawn now.
  [[nodiscard]] std::span<const DrawnNode> drawn() const;

  /// A drawn node is marked when it or an ancestor of it is selected, and tinted when something below it is.
  void setSelection(std::span<const NodeId> nodes);
  [[nodiscard]] const std::vector<NodeId>& selection() const;
  void setHover(NodeId node);  ///< kNoNode: none
  [[nodiscard]] NodeId hover() const;

  void setOverlay(Overlay overlay, bool on);
  [[nodiscard]] bool overlay(Overlay overlay) const;
  void setColours(SceneColours colours);
  [[nodiscard]] SceneColours colours() const;
  void setTheme(SceneTheme theme);
  [[nodiscard]] SceneTheme theme() const;
  /// Layers of `city().lines` and any further lines, drawn on the ground.
  void setLines(const std::vector<LineLayer>& layers);
  void setLayerStyle(SceneLayer layer, const LayerStyle& style);
  [[nodiscard]] const LayerStyle& layerStyle(SceneLayer layer) const;

  void setSize(int width, int height, double pixelRatio = 1) override;
  void setJitter(double x, double y) override;
  /// The camera of the next frame. In plan view: straight above, at the height from which a perspective
  /// camera of this field of view sees the same ground.
  [[nodiscard]] const Camera& camera() const override;
  void setCamera(const Camera& camera) override;
  /// Looks at the buildings (a quarter view from the south-west, or the present direction), a few strays left
  /// aside; when it does so already, at everything. Or looks at one box.
  void fit() override;
  void fitTo(const Box3& box) override;
  /// Looks straight down without perspective, north at the top; leaving it comes back to the direction
  /// before.
  void setPlanView(bool plan) override;
  [[nodiscard]] bool planView() const override;
  [[nodiscard]] Ray through(double x, double y) const override;

  /// What is drawn at a device pixel (x right, y down from the top left). Exact: a ray against the triangles
  /// that are drawn. Cost: below 10 ms for 370,000 buildings.
  [[nodiscard]] std::optional<PickedNode> pick(double x, double y) const;
  /// Point of the ground (or of a building, where one is in the way) under a device pixel; nothing above the
  /// horizon.
  [[nodiscard]] std::optional<Vec3> groundPoint(double x, double y) const override;
  /// Device pixel of a point; nothing behind the eye.
  [[nodiscard]] std::optional<Vec2> project(const Vec3& point) const;

  [[nodiscard]] Box3 bounds() const override;      ///< of everything
  [[nodiscard]] Box3 boundsOf(NodeId node) const;  ///< of one node's block; empty when there is no such node
  [[nodiscard]] double groundHeight() const;       ///< z of the ground plane
  /// All triangles drawn now, for tests and exact tools: corners and node.
  void forEachTriangle(const std::function<void(const std::array<Vec3, 3>&, NodeId)>& visit) const;

  void onChange(std::function<void()> changed) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lodestone
