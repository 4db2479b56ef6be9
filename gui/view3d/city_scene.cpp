#include "gui/view3d/city_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "gui/view3d/camera_ray.h"
#include "gui/view3d/city_picker.h"
#include "gui/view3d/city_prop.h"
#include "gui/view3d/marks.h"
#include "gui/view3d/overlays.h"
#include "gui/view3d/scene_geometry.h"
#include "gui/view3d/scene_lines.h"

namespace lodestone {
namespace {

constexpr double kNearestClip = 0.3;     // metres; a wall that the eye stands at
const Vec3 kFirstLook(0.5, 0.75, -0.6);  // from the south-west, half from above

std::array<std::uint8_t, 4> bytes(const Rgb& colour, std::uint8_t outline) {
  std::array<std::uint8_t, 4> result{0, 0, 0, outline};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = static_cast<std::uint8_t>(std::clamp(colour[i], 0.0F, 1.0F) * 255 + 0.5F);
  return result;
}

Rgb mix(const Rgb& a, const Rgb& b, float share) {
  return {a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share};
}

/// How drawn nodes are marked by a set of nodes.
struct NodeMarks {
  Marks whole;   ///< of all nodes of the set
  Marks hidden;  ///< of those that are not drawn themselves
  [[nodiscard]] Mark of(NodeId node) const {
    return whole.of(node) == Mark::Whole ? Mark::Whole : hidden.of(node);
  }
};

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
  std::uint64_t polygons = 0;
  Vec3 cutEye = Vec3::Zero();
  std::vector<LineLayer> lines;
  std::vector<NodeId> selection;
  std::vector<bool> isDrawn;  ///< by node
  NodeId hover = kNoNode;
  std::array<bool, kOverlayCount> overlays{false, false, true, true, true, true};
  SceneColours colours = SceneColours::ByRole;
  SceneTheme theme = SceneTheme::Light;
  bool cityVisible = true;
  Camera camera;
  bool plan = false;
  Vec3 slant = kFirstLook;  ///< direction to go back to from plan view
  Vec2 jitter = Vec2::Zero();
  bool coloursStale = true;
  bool linesStale = true;
  std::function<void()> changed = [] {};
  unsigned long startTag = 0;

  explicit Impl(vtkRenderer* given)
      : renderer(given), prop(given), streets(given, 1.2, 0.9), hulls(given, 1.6, 1), boxes(given, 1.4, 0.9) {
    camera.eye = camera.target - kFirstLook.normalized() * 200;
  }

  [[nodiscard]] bool shows(Overlay overlay) const { return overlays[static_cast<std::size_t>(overlay)]; }
  [[nodiscard]] const Palette& palette() const {
    return theme == SceneTheme::Dark ? darkPalette() : lightPalette();
  }
  void setDrawn(std::vector<DrawnNode> nodes);
  void updateRanges();
  [[nodiscard]] NodeMarks marksOf(std::span<const NodeId> nodes) const;
  void updateColours();
  void updateLines();
  void applyCamera();
  [[nodiscard]] Rgb baseColour(const DrawnNode& node) const;
  [[nodiscard]] double nearestDepth() const;
  [[nodiscard]] Vec3 lookToFit() const;
  [[nodiscard]] double farthestDepth() const;
  void beforeFrame();
};

void CityScene::Impl::setDrawn(std::vector<DrawnNode> nodes) {
  drawn = std::move(nodes);
  drawnBuildings.clear();
  drawnClusters.clear();
  isDrawn.assign(geometry ? geometry->nodeCount() : 0, false);
  for (const DrawnNode& item : drawn) {
    if (!geometry || item.node >= geometry->nodeCount()) continue;
    isDrawn[item.node] = true;
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
  const bool any = geometry && cityVisible;
  prop->setRanges(CityProp::Buildings,
                  any ? rangesOf(geometry->buildings, drawnBuildings) : std::vector<MeshRange>());
  prop->setRanges(CityProp::Clusters, any && geometry->clusters ? rangesOf(geometry->clusters, drawnClusters)
                                                                : std::vector<MeshRange>());
  prop->setRanges(CityProp::Context,
                  any && geometry->context ? geometry->context->ranges : std::vector<MeshRange>());
}

Rgb CityScene::Impl::baseColour(const DrawnNode& node) const {
  if (node.role == DrawRole::Landmark && shows(Overlay::Landmarks)) return palette().landmark;
  if (node.role != DrawRole::Cluster) return palette().building;
  if (colours == SceneColours::ByRole) return palette().cluster;
  const Rgb colour = clusterColour(node.node);
  return theme == SceneTheme::Dark ? mix(colour, Rgb{0, 0, 0}, 0.25F) : colour;
}

NodeMarks CityScene::Impl::marksOf(std::span<const NodeId> nodes) const {
  if (!geometry || nodes.empty()) return {};
  // What is drawn itself does not tint the cluster around it: a landmark that is picked is marked alone.
  std::vector<NodeId> hidden;
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(hidden),
               [this](NodeId node) { return node < isDrawn.size() && !isDrawn[node]; });
  return {Marks(geometry->leaves, nodes), Marks(geometry->leaves, hidden)};
}

void CityScene::Impl::updateColours() {
  coloursStale = false;
  // The context node has the highest number that a tag can hold; the table ends before it and the shader
  // clamps to the last entry.
  std::vector<std::array<std::uint8_t, 4>> table((geometry ? geometry->nodeCount() : 0) + 1,
                                                 bytes(palette().context, CityProp::kPlain));
  const NodeMarks selected = marksOf(selection);
  const NodeMarks hovered = marksOf(std::span(&hover, hover == kNoNode ? 0 : 1));
  for (const DrawnNode& item : drawn) {
    if (item.node + 1 >= table.size()) continue;
    Rgb colour = baseColour(item);
    std::uint8_t outline = CityProp::kPlain;
    const Mark mark = selected.of(item.node);
    if (mark != Mark::None) {
      colour = mix(colour, palette().selection, mark == Mark::Whole ? 0.80F : 0.35F);
      outline = CityProp::kSelected;
    }
    if (hovered.of(item.node) != Mark::None) {
      colour = mix(colour, palette().hover, mark == Mark::None ? 0.75F : 0.40F);
      if (mark == Mark::None) outline = CityProp::kHovered;
    }
    table[item.node] = bytes(colour, outline);
  }
  prop->setColours(std::move(table));
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

double CityScene::Impl::nearestDepth() const {
  const CameraFrame frame = frameOf(camera);
  const double tanY = std::tan(camera.fov * std::numbers::pi / 360);
  const double tanX = tanY * camera.width / camera.height;
  double nearest = std::numeric_limits<double>::infinity();
  const auto look = [&](const NodeMesh& mesh, const std::vector<NodeId>& nodes) {
    const Vec3 eye = camera.eye - mesh.anchor;
    for (const NodeId node : nodes) {
      const MeshBox& box = mesh.boxes[node - mesh.firstNode];
      if (box.empty()) continue;
      const Vec3 low(box.min[0], box.min[1], box.min[2]);
      const Vec3 high(box.max[0], box.max[1], box.max[2]);
      const double radius = (high - low).norm() / 2;
      const Vec3 offset = (low + high) / 2 - eye;
      const double depth = offset.dot(frame.forward);
      const double reached = depth + radius;
      if (reached < 0 || depth - radius > nearest) continue;
      const double side = 1.5 * radius;  // of the slanted planes, generously
      if (std::abs(offset.dot(frame.right)) - side > reached * tanX) continue;
      if (std::abs(offset.dot(frame.up)) - side > reached * tanY) continue;
      nearest = std::min(nearest, depth - radius);
    }
  };
  if (geometry) {
    look(*geometry->buildings, drawnBuildings);
    if (geometry->clusters) look(*geometry->clusters, drawnClusters);
    if (geometry->context) look(*geometry->context, {geometry->context->firstNode});
  }
  return nearest;
}

double CityScene::Impl::farthestDepth() const {
  const Vec3 forward = frameOf(camera).forward;
  Box3 box = geometry ? geometry->bounds : Box3{};
  if (box.empty()) return 2 * reach(camera);
  if (!lines.empty()) {
    for (const LineLayer& layer : lines) {
      for (const auto& line : layer.lines) {
        for (const Vec2& p : line) box.add(Vec3(p.x(), p.y(), geometry->groundHeight));
      }
    }
  }
  double farthest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) ? box.max.x() : box.min.x(), (corner & 2) ? box.max.y() : box.min.y(),
                 (corner & 4) ? box.max.z() : box.min.z());
    farthest = std::max(farthest, (p - camera.eye).dot(forward));
  }
  return farthest;
}

void CityScene::Impl::applyCamera() {
  vtkCamera* target = renderer->GetActiveCamera();
  const CameraFrame frame = frameOf(camera);
  const Vec3 focus = camera.eye + frame.forward * reach(camera);
  target->SetPosition(camera.eye.data());
  target->SetFocalPoint(focus.data());
  target->SetViewUp(frame.up.data());
  target->SetViewAngle(camera.fov);
  target->SetParallelProjection(plan);
  target->SetParallelScale(parallelScale(camera));
  target->SetWindowCenter(2 * jitter.x() / camera.width, 2 * jitter.y() / camera.height);
  const double farthest = std::max(farthestDepth() * 1.01 + 1, 2 * kNearestClip);
  const double nearest = nearestDepth();
  // Without perspective depths are evenly spread: the eye may stand in front of everything.
  const double front = plan ? std::min(nearest, 0.0) : kNearestClip;
  target->SetClippingRange(std::isfinite(nearest)
                               ? std::clamp(nearest * 0.98 - (plan ? 1 : 0), front, farthest / 2)
                               : farthest / 1000,
                           farthest);
}

void CityScene::Impl::beforeFrame() {
  if (coloursStale) updateColours();
  if (linesStale) updateLines();
  applyCamera();
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
  impl_->polygons = impl_->geometry ? impl_->geometry->buildingPolygons : 0;
  impl_->setDrawn(std::move(all));
}

void CityScene::showCut(const Cut& cut) {
  impl_->polygons = cut.polygons;
  impl_->cutEye = cut.camera.eye;
  impl_->setDrawn(cut.drawn);
}

std::span<const DrawnNode> CityScene::drawn() const {
  return impl_->drawn;
}
std::uint64_t CityScene::polygonsDrawn() const {
  return impl_->polygons;
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
  if (overlay == Overlay::Streets) impl_->streets.setVisible(on);
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
  const double ground = impl_->geometry ? impl_->geometry->groundHeight : 0;
  impl_->streets.setLines(streetLines(layers, ground, impl_->palette()));
  impl_->streets.setVisible(impl_->shows(Overlay::Streets));
  impl_->changed();
}

void CityScene::setCityVisible(bool visible) {
  impl_->cityVisible = visible;
  impl_->updateRanges();
  impl_->changed();
}

void CityScene::setSize(int width, int height, double pixelRatio) {
  impl_->camera.width = std::max(width, 1);
  impl_->camera.height = std::max(height, 1);
  impl_->prop->setPixelRatio(pixelRatio);
  for (LineOverlay* lines : {&impl_->streets, &impl_->hulls, &impl_->boxes}) lines->setPixelRatio(pixelRatio);
}

void CityScene::setJitter(double x, double y) {
  impl_->jitter = Vec2(x, y);
}

const Camera& CityScene::camera() const {
  return impl_->camera;
}

void CityScene::setCamera(const Camera& camera) {
  const int width = impl_->camera.width;
  const int height = impl_->camera.height;
  impl_->camera = camera;
  impl_->camera.width = width;
  impl_->camera.height = height;
  impl_->changed();
}

Vec3 CityScene::Impl::lookToFit() const {
  if (plan) return Vec3(0, 0, -1);
  Vec3 direction = frameOf(camera).forward;
  direction.z() = std::min(direction.z(), -0.15);  // never from below, nor along the ground
  return direction;
}

void CityScene::fit() {
  if (bounds().empty()) return fitTo({});
  FrameFit fit(impl_->camera, impl_->lookToFit(), impl_->plan);
  for (const auto& mesh : {impl_->geometry->buildings, impl_->geometry->context}) {
    if (!mesh) continue;
    for (const MeshBox& box : mesh->boxes) {
      if (box.empty()) continue;
      fit.add({mesh->anchor + Vec3(box.min[0], box.min[1], box.min[2]),
               mesh->anchor + Vec3(box.max[0], box.max[1], box.max[2])});
    }
  }
  setCamera(fit.camera());
}

void CityScene::fitTo(const Box3& box) {
  FrameFit fit(impl_->camera, impl_->lookToFit(), impl_->plan);
  fit.add(box.empty() ? Box3{Vec3(-100, -100, 0), Vec3(100, 100, 30)} : box);
  setCamera(fit.camera());
}

void CityScene::setPlanView(bool plan) {
  if (plan == impl_->plan) return;
  Camera camera = impl_->camera;
  const double distance = reach(camera);
  if (plan) impl_->slant = frameOf(camera).forward;
  impl_->plan = plan;
  camera.eye = camera.target - (plan ? Vec3(0, 0, -1) : impl_->slant.normalized()) * distance;
  setCamera(camera);
}
bool CityScene::planView() const {
  return impl_->plan;
}

std::optional<PickedNode> CityScene::pick(double x, double y) const {
  const auto& scene = impl_->geometry;
  if (!scene || !impl_->cityVisible) return {};
  const Ray ray = rayThrough(impl_->camera, impl_->plan, x, y);
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
  const auto point = meetPlane(rayThrough(impl_->camera, impl_->plan, x, y), groundHeight());
  const double farthest = 50 * std::max(bounds().size().norm(), 1000.0);
  if (!point || (*point - impl_->camera.eye).norm() > farthest) return {};
  return point;
}

std::optional<Vec2> CityScene::project(const Vec3& point) const {
  return projectPoint(impl_->camera, impl_->plan, point);
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
