#include "gui/simplification/sight_link.h"

#include <cmath>
#include <numbers>

namespace lodestone {
namespace {

constexpr double kHandleReach = 12;  // pixels of the toolkit

/// Horizontal field of view, degrees.
double openingOf(const Camera& camera) {
  const double half = std::tan(camera.fov * std::numbers::pi / 360) * camera.width / camera.height;
  return std::atan(half) * 360 / std::numbers::pi;
}

}  // namespace

SightLink::SightLink(Sight& sight, StageView& view, QObject* parent)
    : QObject(parent), sight_(sight), view_(view) {
  view_.view().setTool(this);
  for (const auto change : {&Sight::optionsChanged, &Sight::placingChanged})
    connect(&sight_, change, this, &SightLink::showSight);
  connect(&sight_, &Sight::seenChanged, this, &SightLink::showTargets);
  connect(&sight_, &Sight::targetChanged, this, [this] { view_.scene().setChosenTarget(sight_.target()); });
  connect(&sight_.stage(), &Stage::opened, this, &SightLink::showSight);
  connect(&view_.view(), &StageScene::targetPicked, &sight_,
          [this](std::size_t target) { sight_.choose(target); });
}

SightLink::~SightLink() {
  view_.view().setTool(nullptr);
}

void SightLink::showSight() {
  view_.view().setCursor(sight_.isPlacing() ? Qt::CrossCursor : Qt::ArrowCursor);
  const bool shown = sight_.hasTargets() && sight_.options().placed;
  view_.scene().setSight(shown ? std::optional(sight_.options()) : std::nullopt);
}

void SightLink::showTargets() {
  showSight();
  const auto& seen = sight_.seen();
  view_.scene().setSurroundings(seen ? seen->around : nullptr);
  for (const Past past : kPasts) {
    std::vector<TargetFate> fates;
    const std::size_t count = seen ? seen->around->buildings.size() : 0;
    for (std::uint32_t t = 0; t < count; ++t) fates.push_back(fateOf(*seen, past, t));
    view_.scene().setTargets(static_cast<std::size_t>(past), std::move(fates));
  }
}

void SightLink::set(const SightOptions& options, const QString& what) {
  sight_.setOptions(options, what, QStringLiteral("sight-drag-%1").arg(gesture_));
}

bool SightLink::place(const QPointF& at) {
  const auto ground = view_.scene().groundPoint(at.x(), at.y());
  if (!ground) return false;
  SightOptions options = sight_.options();
  options.standAt(*ground);
  options.turnTo(view_.scene().bounds().center());
  set(options, tr("Place viewpoint"));
  sight_.setPlacing(false);
  return true;
}

bool SightLink::click(const QPointF& at) {
  if (!sight_.isPlacing()) return false;
  ++gesture_;
  place(at);
  return true;  // beside the ground too: it was not meant for the camera or the selection
}

bool SightLink::grab(const QPointF& at) {
  grabbed_.reset();
  pane_ = view_.scene().paneAt(at.x());
  ++gesture_;
  if (sight_.isPlacing()) {
    if (place(at)) grabbed_ = SightHandle::Far;
  } else {
    grabbed_ = handleAt(at);
  }
  return grabbed_.has_value();
}

void SightLink::pull(const QPointF& at) {
  const SightOptions& options = sight_.options();
  const Ray ray = view_.scene().through(pane_, at.x(), at.y());
  const auto to = meetPlane(ray, options.foot().z());
  if (to && grabbed_) set(pulled(options, *grabbed_, *to), tr("Move viewpoint"));
}

void SightLink::release() {
  grabbed_.reset();
}

bool SightLink::cancel() {
  if (!sight_.isPlacing()) return false;
  sight_.setPlacing(false);
  return true;
}

std::optional<SightHandle> SightLink::handleAt(const QPointF& at) const {
  const auto& sight = view_.scene().sight();
  const double ratio = view_.view().devicePixelRatioF();
  std::optional<SightHandle> nearest;
  double distance = kHandleReach * ratio;
  for (const SightHandle handle : kSightHandles) {
    const auto pixel = sight ? view_.scene().project(pane_, handlePoint(*sight, handle)) : std::nullopt;
    if (!pixel) continue;
    const double away = (*pixel - Vec2(at.x(), at.y())).norm();
    if (away > distance) continue;
    distance = away;
    nearest = handle;
  }
  return nearest;
}

void SightLink::standAtCamera() {
  const Camera camera = view_.view().camera();
  const double ground = view_.scene().groundHeight();
  SightOptions options = sight_.options();
  options.standAt(Vec3(camera.eye.x(), camera.eye.y(), std::min(ground, camera.eye.z())));
  options.height = camera.eye.z() - options.z;
  options.lookAlong(camera.target - camera.eye);
  options.angle = openingOf(camera);
  ++gesture_;
  set(options, tr("Viewpoint from the camera"));
  sight_.setPlacing(false);
}

void SightLink::lookFromViewpoint() {
  const SightOptions& options = sight_.options();
  view_.view().setPlanView(false);
  Camera camera = view_.view().camera();
  const double reach = std::max((view_.scene().bounds().center() - options.eye()).norm(), 1e-3);
  camera.eye = options.eye();
  camera.target = options.eye() + options.direction() * reach;
  view_.view().setCamera(camera);
}

}  // namespace lodestone
