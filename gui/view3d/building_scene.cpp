#include "gui/view3d/building_scene.h"

#include <algorithm>
#include <cmath>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "gui/view3d/city_picker.h"

namespace lodestone {
namespace {

/// FrameFit leaves half a metre before the eye: a building of any unit is fitted as if it had this diagonal.
constexpr double kFittedDiagonal = 100;

}  // namespace

BuildingScene::BuildingScene(const std::vector<vtkSmartPointer<vtkRenderer>>& renderers) {
  for (std::size_t i = 0; i < kPanes; ++i) {
    panes_[i] = std::make_unique<BuildingPane>(renderers[i]);
    vtkNew<vtkCallbackCommand> start;
    start->SetClientData(this);
    start->SetCallback([](vtkObject*, unsigned long, void* scene, void*) {
      static_cast<BuildingScene*>(scene)->beforeFrame();
    });
    startTags_[i] = renderers[i]->AddObserver(vtkCommand::StartEvent, start);
  }
  arrange();
}

BuildingScene::~BuildingScene() {
  for (std::size_t i = 0; i < kPanes; ++i) panes_[i]->renderer().RemoveObserver(startTags_[i]);
}

void BuildingScene::setModel(std::size_t pane, std::shared_ptr<const PaneModel> model) {
  if (pane == 0) bounds_ = model ? lodestone::bounds(*model->mesh) : Box3{};
  panes_[pane]->setModel(std::move(model), look_);
  panes_[pane]->setGround(groundHeight());
  changed_();
}

std::shared_ptr<const PaneModel> BuildingScene::model(std::size_t pane) const {
  return panes_[pane]->model();
}

void BuildingScene::setContacts(std::size_t pane, const std::vector<ContactMark>& marks) {
  panes_[pane]->setContacts(marks);
  changed_();
}

void BuildingScene::setSurroundings(std::shared_ptr<const Surroundings> around) {
  if (around == around_) return;
  around_ = std::move(around);
  for (auto& pane : panes_) pane->setSurroundings(around_, look_);
  changed_();
}

void BuildingScene::setTargets(std::size_t pane, std::vector<TargetFate> fates) {
  panes_[pane]->setTargets(std::move(fates), look_);
  changed_();
}

void BuildingScene::setChosenTarget(std::optional<std::size_t> target) {
  look_.target = target;
  for (auto& pane : panes_) pane->recolour(look_);
  changed_();
}

void BuildingScene::setSight(const std::optional<SightOptions>& sight) {
  sight_ = sight;
  for (auto& pane : panes_) pane->setSight(sight_, look_.palette);
  changed_();
}

void BuildingScene::setLayout(PaneLayout layout, std::vector<std::size_t> panes) {
  layout_ = panes.size() > 1 ? layout : PaneLayout::Side;
  shown_ = std::move(panes);
  if (layout_ == PaneLayout::Wipe) shown_.resize(2);
  arrange();
  changed_();
}

void BuildingScene::setWipe(double share) {
  wipe_ = std::clamp(share, 0.02, 0.98);
  arrange();
  changed_();
}

void BuildingScene::setLook(const BuildingLook& look) {
  const auto target = look_.target;
  look_ = look;
  look_.target = target;
  for (auto& pane : panes_) {
    pane->show(look_);
    pane->setSight(sight_, look_.palette);
  }
  changed_();
}

void BuildingScene::setHover(std::uint32_t component) {
  if (look_.hover == component) return;
  look_.hover = component;
  for (auto& pane : panes_) pane->recolour(look_);
  changed_();
}

std::pair<double, double> BuildingScene::span(std::size_t place) const {
  if (layout_ == PaneLayout::Wipe) {
    const double line = std::round(wipe_ * width_);
    return place == 0 ? std::pair(0.0, line) : std::pair(line, static_cast<double>(width_));
  }
  const auto count = static_cast<double>(shown_.size());
  return {std::round(static_cast<double>(place) * width_ / count),
          std::round(static_cast<double>(place + 1) * width_ / count)};
}

std::size_t BuildingScene::placeAt(double x) const {
  std::size_t place = 0;
  while (place + 1 < shown_.size() && x >= span(place).second) ++place;
  return place;
}

std::size_t BuildingScene::placeOf(std::size_t pane) const {
  return static_cast<std::size_t>(std::find(shown_.begin(), shown_.end(), pane) - shown_.begin());
}

std::pair<double, double> BuildingScene::spanOf(std::size_t pane) const {
  return span(placeOf(pane));
}

void BuildingScene::arrange() {
  const double paneWidth = layout_ == PaneLayout::Wipe ? width_ : width_ / static_cast<double>(shown_.size());
  camera_.setSize(static_cast<int>(std::lround(paneWidth)), height_);
  for (std::size_t pane = 0; pane < kPanes; ++pane) {
    const std::size_t place = placeOf(pane);
    const bool drawn = place < shown_.size();
    panes_[pane]->renderer().SetDraw(drawn);
    if (!drawn) continue;
    const auto [left, right] = span(place);
    panes_[pane]->renderer().SetViewport(left / width_, 0, right / width_, 1);
  }
}

void BuildingScene::setSize(int width, int height, double pixelRatio) {
  width_ = std::max(width, 1);
  height_ = std::max(height, 1);
  for (auto& pane : panes_) pane->setPixelRatio(pixelRatio);
  arrange();
}

void BuildingScene::setJitter(double x, double y) {
  jitter_ = Vec2(x, y);
}

void BuildingScene::setCamera(const Camera& camera) {
  camera_.set(camera);
  changed_();
}

void BuildingScene::fit() {
  const Camera before = camera();
  fitTo(bounds_);
  const double moved = (camera().eye - before.eye).norm();
  if ((around_ || sight_) && moved < 1e-6 * reach(before)) fitTo(everything());
}

Box3 BuildingScene::everything() const {
  Box3 box = bounds_;
  if (around_) box.add(around_->bounds);
  if (sight_) box.add(lodestone::bounds(*sight_));
  return box;
}

void BuildingScene::fitTo(const Box3& given) {
  const double diagonal = given.size().norm();
  if (given.empty() || diagonal == 0) return;
  const double scale = kFittedDiagonal / diagonal;
  Vec3 direction = planView() ? Vec3(0, 0, -1) : frameOf(camera()).forward;
  if (!planView() && given.min == bounds_.min && given.max == bounds_.max)
    direction.z() = std::min(direction.z(), -0.15);
  FrameFit fit(camera(), direction, planView());
  fit.add({given.min * scale, given.max * scale});
  Camera camera = fit.camera();
  camera.eye /= scale;
  camera.target /= scale;
  setCamera(camera);
}

void BuildingScene::setPlanView(bool plan) {
  camera_.setPlan(plan);
  changed_();
}

CameraLimits BuildingScene::limits() const {
  const double size = bounds_.empty() ? 1 : bounds_.size().norm();
  return {.leastHeight = -1e3 * size, .nearest = 2e-3 * size, .flattest = -85};
}

Ray BuildingScene::through(double x, double y) const {
  return through(paneAt(x), x, y);
}

Ray BuildingScene::through(std::size_t pane, double x, double y) const {
  const double left = layout_ == PaneLayout::Wipe ? 0 : spanOf(pane).first;
  return camera_.through(x - left, y);
}

std::optional<Vec2> BuildingScene::project(std::size_t pane, const Vec3& point) const {
  const std::size_t place = placeOf(pane);
  if (place >= shown_.size()) return {};
  auto at = camera_.project(point);
  if (!at) return {};
  const auto [left, right] = span(place);
  if (layout_ == PaneLayout::Side) at->x() += left;
  if (at->x() < left || at->x() >= right) return {};
  return at;
}

std::optional<std::uint32_t> BuildingScene::vertexNear(const PaneModel& model, std::size_t pane,
                                                       const Vec2& at, double reach, double depth) const {
  const Vec3 eye = camera().eye;
  const Vec3 forward = frameOf(camera()).forward;
  std::optional<std::uint32_t> best;
  double bestDistance = reach;
  for (std::size_t c = 0; c < model.component.size(); ++c) {
    if (!look_.isolated.empty() && !look_.isolated[model.component[c]]) continue;
    const Component& component = model.mesh->components[c];
    for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v) {
      const Vec3& p = model.mesh->vertices[v];
      const double behind = (p - eye).dot(forward) - depth;
      if (behind > 0.01 * std::abs(depth)) continue;  // hidden by what the pixel shows
      const auto pixel = project(pane, p);
      if (!pixel || (*pixel - at).norm() >= bestDistance) continue;
      best = v;
      bestDistance = (*pixel - at).norm();
    }
  }
  if (best) best = model.vertex[*best];
  return best;
}

std::optional<PickedPart> BuildingScene::pick(double x, double y, double reach) const {
  const std::size_t pane = shown_[placeAt(x)];
  const auto model = panes_[pane]->model();
  if (!model) return {};
  const Ray ray = through(x, y);
  const auto hit = castRay(*model->nodes, panes_[pane]->solid(), ray.origin, ray.direction);
  if (!hit) return {};
  PickedPart picked{pane, hit->node, {}, ray.at(hit->distance)};
  if (reach > 0) {
    const double depth = (picked.point - camera().eye).dot(frameOf(camera()).forward);
    picked.vertex = vertexNear(*model, pane, Vec2(x, y), reach, depth);
  }
  return picked;
}

std::optional<std::size_t> BuildingScene::pickTarget(double x, double y) const {
  if (!around_) return {};
  const Ray ray = through(x, y);
  const auto hit = castRay(around_->mesh, around_->nodes, ray.origin, ray.direction);
  if (!hit) return {};
  const auto nearer = pick(x, y);
  if (nearer && (nearer->point - ray.origin).norm() <= hit->distance) return {};
  return hit->node - around_->mesh.firstNode;
}

std::optional<Vec3> BuildingScene::groundPoint(double x, double y) const {
  const Ray ray = through(x, y);
  const auto picked = pick(x, y);
  const auto other =
      around_ ? castRay(around_->mesh, around_->nodes, ray.origin, ray.direction) : std::nullopt;
  if (other && (!picked || other->distance < (picked->point - ray.origin).norm()))
    return ray.at(other->distance);
  if (picked) return picked->point;
  const auto point = meetPlane(ray, groundHeight());
  if (!point || (*point - camera().eye).norm() > 50 * bounds_.size().norm()) return {};
  return point;
}

void BuildingScene::aim(vtkRenderer& renderer, std::size_t place) const {
  vtkCamera& target = *renderer.GetActiveCamera();
  const CameraFrame frame = frameOf(camera());
  const Vec3 focus = camera().eye + frame.forward * reach(camera());
  target.SetPosition(camera().eye.data());
  target.SetFocalPoint(focus.data());
  target.SetViewUp(frame.up.data());
  target.SetViewAngle(camera().fov);
  target.SetParallelProjection(planView());
  target.SetParallelScale(parallelScale(camera()));
  const auto [left, right] = span(place);
  // A wiped pane is a part of one picture: its middle lies off the camera's axis.
  const double off = layout_ == PaneLayout::Wipe ? (left + right - width_) / (right - left) : 0;
  target.SetWindowCenter(off + 2 * jitter_.x() / (right - left), 2 * jitter_.y() / height_);
  const double radius = std::max(bounds_.empty() ? 1 : bounds_.size().norm() / 2, 1e-6);
  const double depth = bounds_.empty() ? 1 : (bounds_.center() - camera().eye).dot(frame.forward);
  double farthest = std::max(depth + 1.05 * radius, radius * 0.02);
  double least = planView() ? depth - 1.05 * radius : std::max(depth - 1.05 * radius, radius * 1e-3);
  if (around_) {
    const DrawnPart part{around_->mesh, around_->nodes};
    const double nearest = 0.98 * camera_.nearestDepth({&part, 1});
    least = std::min(least, planView() ? nearest - radius : std::max(nearest, radius * 1e-3));
  }
  if (around_ || sight_) farthest = std::max(farthest, 1.01 * camera_.farthestDepth(everything()));
  target.SetClippingRange(least, farthest);
}

void BuildingScene::beforeFrame() {
  for (std::size_t place = 0; place < shown_.size(); ++place) aim(panes_[shown_[place]]->renderer(), place);
}

}  // namespace lodestone
