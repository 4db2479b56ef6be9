#include "gui/view3d/city_scene.h"

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace lodestone {

struct CityScene::Impl {
  vtkSmartPointer<vtkRenderer> renderer;
  std::shared_ptr<const CityModel> city;
  std::shared_ptr<const ClusterTree> tree;
  std::vector<DrawnNode> drawn;
  std::uint64_t polygons = 0;
  std::vector<NodeId> selection;
  NodeId hover = kNoNode;
  std::array<bool, kOverlayCount> overlays{false, false, true, true, true, true};
  SceneColours colours = SceneColours::ByRole;
  SceneTheme theme = SceneTheme::Light;
  Camera camera;
  bool plan = false;
  std::function<void()> changed = [] {};
};

CityScene::CityScene(vtkRenderer* renderer) : impl_(std::make_unique<Impl>()) {
  impl_->renderer = renderer;
}
CityScene::~CityScene() = default;

void CityScene::setCity(std::shared_ptr<const CityModel> city, std::shared_ptr<const ClusterTree> tree) {
  impl_->city = std::move(city);
  impl_->tree = std::move(tree);
  showAllBuildings();
}
const std::shared_ptr<const CityModel>& CityScene::city() const {
  return impl_->city;
}
const std::shared_ptr<const ClusterTree>& CityScene::tree() const {
  return impl_->tree;
}
void CityScene::showAllBuildings() {
  impl_->drawn.clear();
  const std::size_t count = impl_->city ? impl_->city->buildings.size() : 0;
  for (std::size_t i = 0; i < count; ++i)
    impl_->drawn.push_back({static_cast<NodeId>(i), DrawRole::Building});
  impl_->changed();
}
void CityScene::showCut(const Cut& cut) {
  impl_->drawn = cut.drawn;
  impl_->polygons = cut.polygons;
  impl_->changed();
}
std::span<const DrawnNode> CityScene::drawn() const {
  return impl_->drawn;
}
std::uint64_t CityScene::polygonsDrawn() const {
  return impl_->polygons;
}
void CityScene::setSelection(std::span<const NodeId> nodes) {
  impl_->selection.assign(nodes.begin(), nodes.end());
}
const std::vector<NodeId>& CityScene::selection() const {
  return impl_->selection;
}
void CityScene::setHover(NodeId node) {
  impl_->hover = node;
}
NodeId CityScene::hover() const {
  return impl_->hover;
}
void CityScene::setOverlay(Overlay overlay, bool on) {
  impl_->overlays[static_cast<std::size_t>(overlay)] = on;
}
bool CityScene::overlay(Overlay overlay) const {
  return impl_->overlays[static_cast<std::size_t>(overlay)];
}
void CityScene::setColours(SceneColours colours) {
  impl_->colours = colours;
}
SceneColours CityScene::colours() const {
  return impl_->colours;
}
void CityScene::setTheme(SceneTheme theme) {
  impl_->theme = theme;
}
SceneTheme CityScene::theme() const {
  return impl_->theme;
}
void CityScene::setLines(const std::vector<LineLayer>&) {}
void CityScene::setCityVisible(bool) {}
void CityScene::setSize(int width, int height) {
  impl_->camera.width = width;
  impl_->camera.height = height;
}
const Camera& CityScene::camera() const {
  return impl_->camera;
}
void CityScene::setCamera(const Camera& camera) {
  impl_->camera = camera;
  impl_->changed();
}
void CityScene::fit() {}
void CityScene::fitTo(const Box3&) {}
void CityScene::setPlanView(bool plan) {
  impl_->plan = plan;
}
bool CityScene::planView() const {
  return impl_->plan;
}
std::optional<PickedNode> CityScene::pick(double, double) const {
  return {};
}
std::optional<Vec3> CityScene::groundPoint(double, double) const {
  return {};
}
std::optional<Vec2> CityScene::project(const Vec3&) const {
  return {};
}
Box3 CityScene::bounds() const {
  return impl_->city ? lodestone::bounds(*impl_->city) : Box3{};
}
Box3 CityScene::boundsOf(NodeId) const {
  return {};
}
double CityScene::groundHeight() const {
  return 0;
}
void CityScene::forEachTriangle(const std::function<void(const std::array<Vec3, 3>&, NodeId)>&) const {}
void CityScene::onChange(std::function<void()> changed) {
  impl_->changed = std::move(changed);
}

}  // namespace lodestone
