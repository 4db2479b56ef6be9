#include "gui/view3d/city_scene.h"

#include <algorithm>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "gui/view3d/city_picker.h"
#include "gui/view3d/city_prop.h"
#include "gui/view3d/node_colours.h"
#include "gui/view3d/overlays.h"
#include "gui/view3d/scene_camera.h"
#include "gui/view3d/scene_geometry.h"
#include "gui/view3d/scene_lines.h"

namespace lodestone {
namespace {

/// The city's own prop, first in its renderer: it paints every pixel, and what comes after lies over it.
class PropInRenderer {
 public:
  explicit PropInRenderer(vtkRenderer* renderer) : renderer_(renderer) { renderer_->AddViewProp(prop_); }
  ~PropInRenderer() { renderer_->RemoveViewProp(prop_); }
  PropInRenderer(const PropInRenderer&) = delete;
  PropInRenderer& operator=(const PropInRenderer&) = delete;
  CityProp* operator->() const { return prop_; }

 private:
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkNew<CityProp> prop_;
};

}  // namespace

struct CityScene::Impl {
  vtkSmartPointer<vtkRenderer> renderer;
  PropInRenderer prop;
  LineOverlay streets, hulls, boxes;
  std::shared_ptr<const SceneGeometry> geometry;
  std::vector<DrawnNode> drawn;
  std::vector<NodeId> drawnBuildings, drawnClusters;
  Vec3 cutEye = Vec3::Zero();
  std::vector<LineLayer> lines;
  Box2 lineBounds;
  std::vector<NodeId> selection;
  NodeId hover = kNoNode;
  std::array<bool, kOverlayCount> overlays{false, false, true, true, true, true};
  SceneColours colours = SceneColours::ByRole;
  SceneTheme theme = SceneTheme::Light;
  std::array<LayerStyle, kSceneLayerCount> styles;
  SceneCamera camera;
  bool coloursStale = true;
  bool linesStale = true;
  std::function<void()> changed = [] {};
  unsigned long startTag = 0;

  explicit Impl(vtkRenderer* given)
      : renderer(given),
        prop(given),
        streets(given, 1.2, 0.9),
        hulls(given, 1.6, 1),
        boxes(given, 1.4, 0.9) {}

  [[nodiscard]] bool shows(Overlay overlay) const { return overlays[static_cast<std::size_t>(overlay)]; }
  [[nodiscard]] const LayerStyle& style(SceneLayer layer) const {
    return styles[static_cast<std::size_t>(layer)];
  }
  [[nodiscard]] const Palette& palette() const {
    return theme == SceneTheme::Dark ? darkPalette() : lightPalette();
  }
  void setDrawn(std::vector<DrawnNode> nodes);
  void updateRanges();
  void updateColours();
  void updateLines();
  void updateStreets();
  void styleStreets();
  void aimCamera();
  void beforeFrame();
};

void CityScene::Impl::setDrawn(std::vector<DrawnNode> nodes) {
  drawn = std::move(nodes);
  drawnBuildings.clear();
  drawnClusters.clear();
  for (const DrawnNode& item : drawn) {
    if (!geometry || item.node >= geometry->nodeCount()) continue;
    (geometry->buildings->has(item.node) ? drawnBuildings : drawnClusters).push_back(item.node);
  }
  updateRanges();
  coloursStale = linesStale = true;
  changed();
}

void CityScene::Impl::updateRanges() {
  const auto rangesOf = [](const std::shared_ptr<const NodeMesh>& mesh, std::vector<NodeId>& nodes) {
    std::sort(nodes.begin(), nodes.end());  // neighbours in the buffer are drawn in one go
    std::vector<MeshRange> ranges;
    ranges.reserve(nodes.size());
    for (const NodeId node : nodes) ranges.push_back(mesh->ranges[node - mesh->firstNode]);
    return ranges;
  };
  const bool any = geometry && style(SceneLayer::Buildings).visible;
  const bool context = geometry && geometry->context && style(SceneLayer::Surroundings).visible;
  prop->setRanges(CityProp::Buildings,
                  any ? rangesOf(geometry->buildings, drawnBuildings) : std::vector<MeshRange>());
  prop->setRanges(CityProp::Clusters, any && geometry->clusters ? rangesOf(geometry->clusters, drawnClusters)
                                                                : std::vector<MeshRange>());
  prop->setRanges(CityProp::Context, context ? geometry->context->ranges : std::vector<MeshRange>());
}

void CityScene::Impl::updateColours() {
  coloursStale = false;
  NodeColouring colouring{palette()};
  colouring.dark = theme == SceneTheme::Dark;
  colouring.byCluster = colours == SceneColours::ByCluster;
  colouring.showLandmarks = shows(Overlay::Landmarks);
  colouring.building = style(SceneLayer::Buildings).colour;
  colouring.context = style(SceneLayer::Surroundings).colour;
  colouring.selection = selection;
  colouring.hover = hover;
  prop->setColours(nodeColours(geometry.get(), drawn, colouring));
}

void CityScene::Impl::updateLines() {
  linesStale = false;
  const ClusterTree* tree = geometry ? geometry->tree.get() : nullptr;
  const bool ground = geometry != nullptr && shows(Overlay::Ground);
  prop->setGround(geometry ? geometry->groundHeight : 0, ground || !geometry, true);
  prop->setEdges(shows(Overlay::Edges));
  prop->setPalette(palette());
  const bool showHulls = tree && shows(Overlay::Hulls);
  const bool showBoxes = tree && shows(Overlay::NegativeSpace);
  if (showHulls) hulls.setLines(hullLines(*tree, drawn, palette()));
  if (showBoxes) boxes.setLines(negativeSpaceLines(*tree, drawn, cutEye, palette()));
  hulls.setVisible(showHulls);
  boxes.setVisible(showBoxes);
}

void CityScene::Impl::updateStreets() {
  const double ground = geometry ? geometry->groundHeight : 0;
  streets.setLines(streetLines(lines, ground, palette(), style(SceneLayer::Lines).colour));
  styleStreets();
}

void CityScene::Impl::styleStreets() {
  const LayerStyle& given = style(SceneLayer::Lines);
  streets.setOpacity(0.9 * given.opacity);
  streets.setVisible(shows(Overlay::Streets) && given.visible);
}

void CityScene::Impl::aimCamera() {
  std::vector<DrawnPart> parts;
  Box3 everything;
  if (geometry) {
    everything = geometry->bounds;
    if (!everything.empty() && !lineBounds.empty()) {
      for (const Vec2& corner : {lineBounds.min, lineBounds.max})
        everything.add(Vec3(corner.x(), corner.y(), geometry->groundHeight));
    }
    parts.push_back({*geometry->buildings, drawnBuildings});
    if (geometry->clusters) parts.push_back({*geometry->clusters, drawnClusters});
    if (geometry->context) parts.push_back({*geometry->context, std::span(&geometry->context->firstNode, 1)});
  }
  camera.aim(*renderer->GetActiveCamera(), parts, everything);
}

void CityScene::Impl::beforeFrame() {
  if (coloursStale) updateColours();
  if (linesStale) updateLines();
  aimCamera();
}

CityScene::CityScene(vtkRenderer* renderer) : impl_(std::make_unique<Impl>(renderer)) {
  vtkNew<vtkCallbackCommand> start;
  start->SetClientData(impl_.get());
  start->SetCallback(
      [](vtkObject*, unsigned long, void* scene, void*) { static_cast<Impl*>(scene)->beforeFrame(); });
  impl_->startTag = renderer->AddObserver(vtkCommand::StartEvent, start);
}

CityScene::~CityScene() {
  impl_->renderer->RemoveObserver(impl_->startTag);
}

void CityScene::setCity(std::shared_ptr<const CityModel> city, std::shared_ptr<const ClusterTree> tree,
                        std::shared_ptr<const SceneGeometry> prepared) {
  const auto before = impl_->geometry;
  const bool fits = prepared && prepared->city == city && prepared->tree == tree;
  impl_->geometry = fits ? std::move(prepared) : makeSceneGeometry(city, std::move(tree), before.get());
  const auto& now = impl_->geometry;
  if (!now || !before || now->buildings != before->buildings) {
    impl_->prop->setMesh(CityProp::Buildings, now ? now->buildings : nullptr);
    impl_->prop->setMesh(CityProp::Context, now ? now->context : nullptr);
    impl_->selection.clear();
    setLines(now ? now->city->lines : std::vector<LineLayer>());
  }
  impl_->prop->setMesh(CityProp::Clusters, now ? now->clusters : nullptr);
  impl_->prop->setHazeDistance(now && !now->bounds.empty() ? 1.5 * now->bounds.size().norm() : 1e4);
  std::erase_if(impl_->selection, [&](NodeId node) { return node >= now->buildingCount(); });
  impl_->hover = kNoNode;
  setSelection(std::vector<NodeId>(impl_->selection));
  showAllBuildings();
}

std::shared_ptr<const CityModel> CityScene::city() const {
  return impl_->geometry ? impl_->geometry->city : nullptr;
}
std::shared_ptr<const ClusterTree> CityScene::tree() const {
  return impl_->geometry ? impl_->geometry->tree : nullptr;
}
std::shared_ptr<const SceneGeometry> CityScene::geometry() const {
  return impl_->geometry;
}

void CityScene::showAllBuildings() {
  std::vector<DrawnNode> all(impl_->geometry ? impl_->geometry->buildingCount() : 0);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].node = static_cast<NodeId>(i);
  impl_->setDrawn(std::move(all));
}

void CityScene::showCut(const Cut& cut) {
  impl_->cutEye = cut.camera.eye;
  impl_->setDrawn(cut.drawn);
}

std::span<const DrawnNode> CityScene::drawn() const {
  return impl_->drawn;
}

void CityScene::setSelection(std::span<const NodeId> nodes) {
  impl_->selection.assign(nodes.begin(), nodes.end());
  impl_->coloursStale = true;
  impl_->changed();
}
const std::vector<NodeId>& CityScene::selection() const {
  return impl_->selection;
}

void CityScene::setHover(NodeId node) {
  if (impl_->hover == node) return;
  impl_->hover = node;
  impl_->coloursStale = true;
  impl_->changed();
}
NodeId CityScene::hover() const {
  return impl_->hover;
}

void CityScene::setOverlay(Overlay overlay, bool on) {
  impl_->overlays[static_cast<std::size_t>(overlay)] = on;
  if (overlay == Overlay::Streets) impl_->styleStreets();
  impl_->coloursStale = impl_->linesStale = true;
  impl_->changed();
}
bool CityScene::overlay(Overlay overlay) const {
  return impl_->shows(overlay);
}

void CityScene::setColours(SceneColours colours) {
  impl_->colours = colours;
  impl_->coloursStale = true;
  impl_->changed();
}
SceneColours CityScene::colours() const {
  return impl_->colours;
}

void CityScene::setTheme(SceneTheme theme) {
  impl_->theme = theme;
  impl_->coloursStale = impl_->linesStale = true;
  setLines(std::vector<LineLayer>(impl_->lines));
}
SceneTheme CityScene::theme() const {
  return impl_->theme;
}

void CityScene::setLines(const std::vector<LineLayer>& layers) {
  impl_->lines = layers;
  impl_->lineBounds = {};
  for (const LineLayer& layer : layers) {
    for (const auto& line : layer.lines) {
      for (const Vec2& point : line) impl_->lineBounds.add(point);
    }
  }
  impl_->updateStreets();
  impl_->changed();
}

void CityScene::setLayerStyle(SceneLayer layer, const LayerStyle& style) {
  LayerStyle& own = impl_->styles[static_cast<std::size_t>(layer)];
  const bool recolours = layer == SceneLayer::Lines && own.colour != style.colour;
  own = style;
  if (recolours) impl_->updateStreets();
  impl_->prop->setOpacity(impl_->style(SceneLayer::Buildings).opacity,
                          impl_->style(SceneLayer::Surroundings).opacity);
  impl_->updateRanges();
  impl_->styleStreets();
  impl_->coloursStale = true;
  impl_->changed();
}
const LayerStyle& CityScene::layerStyle(SceneLayer layer) const {
  return impl_->style(layer);
}

void CityScene::setSize(int width, int height, double pixelRatio) {
  impl_->camera.setSize(width, height);
  impl_->prop->setPixelRatio(pixelRatio);
  for (LineOverlay* lines : {&impl_->streets, &impl_->hulls, &impl_->boxes}) lines->setPixelRatio(pixelRatio);
}

void CityScene::setJitter(double x, double y) {
  impl_->camera.setJitter(x, y);
}

const Camera& CityScene::camera() const {
  return impl_->camera.camera();
}

void CityScene::setCamera(const Camera& camera) {
  impl_->camera.set(camera);
  impl_->changed();
}

void CityScene::fit() {
  impl_->camera.fit(impl_->geometry.get());
  impl_->changed();
}

void CityScene::fitTo(const Box3& box) {
  impl_->camera.fitTo(box);
  impl_->changed();
}

void CityScene::setPlanView(bool plan) {
  impl_->camera.setPlan(plan);
  impl_->changed();
}
bool CityScene::planView() const {
  return impl_->camera.plan();
}

Ray CityScene::through(double x, double y) const {
  return impl_->camera.through(x, y);
}

std::optional<PickedNode> CityScene::pick(double x, double y) const {
  const auto& scene = impl_->geometry;
  if (!scene || !impl_->style(SceneLayer::Buildings).visible) return {};
  const Ray ray = impl_->camera.through(x, y);
  auto hit = castRay(*scene->buildings, impl_->drawnBuildings, ray.origin, ray.direction);
  if (scene->clusters) {
    const auto other = castRay(*scene->clusters, impl_->drawnClusters, ray.origin, ray.direction);
    // A landmark's wall may lie in its cluster's: the landmark is what is drawn.
    if (other && (!hit || other->distance < hit->distance * (1 - 1e-7))) hit = other;
  }
  if (!hit) return {};
  PickedNode picked{hit->node, DrawRole::Building, kNoNode, ray.at(hit->distance), hit->distance};
  const auto found = std::find_if(impl_->drawn.begin(), impl_->drawn.end(),
                                  [&](const DrawnNode& item) { return item.node == hit->node; });
  if (found != impl_->drawn.end()) {
    picked.role = found->role;
    picked.of = found->of;
  }
  return picked;
}

std::optional<Vec3> CityScene::groundPoint(double x, double y) const {
  if (const auto picked = pick(x, y)) return picked->point;
  const auto point = meetPlane(impl_->camera.through(x, y), groundHeight());
  const double farthest = 50 * std::max(bounds().size().norm(), 1000.0);
  if (!point || (*point - impl_->camera.camera().eye).norm() > farthest) return {};
  return point;
}

std::optional<Vec2> CityScene::project(const Vec3& point) const {
  return impl_->camera.project(point);
}

Box3 CityScene::bounds() const {
  return impl_->geometry ? impl_->geometry->bounds : Box3{};
}

Box3 CityScene::boundsOf(NodeId node) const {
  const NodeMesh* mesh = impl_->geometry ? impl_->geometry->meshOf(node) : nullptr;
  if (!mesh || mesh->boxes[node - mesh->firstNode].empty()) return {};
  const MeshBox& box = mesh->boxes[node - mesh->firstNode];
  return {mesh->anchor + Vec3(box.min[0], box.min[1], box.min[2]),
          mesh->anchor + Vec3(box.max[0], box.max[1], box.max[2])};
}

double CityScene::groundHeight() const {
  return impl_->geometry ? impl_->geometry->groundHeight : 0;
}

void CityScene::forEachTriangle(const std::function<void(const std::array<Vec3, 3>&, NodeId)>& visit) const {
  if (!impl_->geometry) return;
  for (const DrawnNode& item : impl_->drawn) {
    const NodeMesh* mesh = impl_->geometry->meshOf(item.node);
    if (!mesh) continue;
    const MeshRange& range = mesh->ranges[item.node - mesh->firstNode];
    for (std::uint32_t i = range.first; i < range.first + range.count; i += 3)
      visit(triangleOf(*mesh, i), item.node);
  }
}

void CityScene::onChange(std::function<void()> changed) {
  impl_->changed = std::move(changed);
}

}  // namespace lodestone
