#include "gui/simplification/sight.h"

namespace lodestone {
namespace {

constexpr int kDebounceMs = 60;

}  // namespace

Sight::Sight(Stage& stage, Workspace& workspace, QObject* parent)
    : QObject(parent), stage_(stage), workspace_(workspace) {
  debounce_.setSingleShot(true);
  debounce_.setInterval(kDebounceMs);
  connect(&debounce_, &QTimer::timeout, this, &Sight::look);
  for (const auto change : {&Stage::opening, &Stage::closed}) connect(&stage_, change, this, &Sight::forget);
  for (const auto change : {&Stage::opened, &Stage::comparingChanged})
    connect(&stage_, change, this, &Sight::follow);
  connect(&stage_, &Stage::levelChanged, this, &Sight::follow);
  connect(&workspace_, &Workspace::stateChanged, this,
          [this](const ProjectState& before, const ProjectState& after) {
            if (before.sight == after.sight) return;
            Q_EMIT optionsChanged();
            follow();
          });
  connect(&workspace_.tasks(), &TaskRunner::finished, this, [this](const QString& key) {
    if (key == task()) Q_EMIT looking();
  });
}

const SightOptions& Sight::options() const {
  return workspace_.state().sight;
}

void Sight::setOptions(const SightOptions& options, const QString& what, const QString& mergeKey) {
  workspace_.setSight(options, what, mergeKey);
}

void Sight::remove() {
  setPlacing(false);
  SightOptions next = options();
  next.placed = false;
  setOptions(next, tr("Remove viewpoint"));
}

void Sight::setPlacing(bool placing) {
  if (placing == placing_) return;
  placing_ = placing;
  Q_EMIT placingChanged();
  follow();
}

bool Sight::hasTargets() const {
  return stage_.isOpen() && stage_.staged()->city->buildings.size() > stage_.staged()->buildings.size();
}

bool Sight::isWanted() const {
  return hasTargets() && (placing_ || options().placed);
}

PastModels Sight::models() const {
  PastModels models;
  if (!stage_.isOpen()) return models;
  models[static_cast<std::size_t>(Past::Original)] = stage_.staged()->mesh;
  for (const auto& [past, method] : {std::pair(Past::A, Stage::A), std::pair(Past::B, Stage::B)}) {
    const auto& level = stage_.level(method);
    if (level && (method == Stage::A || stage_.comparing()))
      models[static_cast<std::size_t>(past)] =
          std::shared_ptr<const ComponentMesh>(level->simplified, &level->simplified->mesh);
  }
  return models;
}

bool Sight::isOutdated() const {
  return isWanted() && (!seen_ || seen_->options != options() || seen_->models != models());
}

bool Sight::isLooking() const {
  return debounce_.isActive() || workspace_.tasks().busy(task());
}

const Sighting* Sight::sighting(Past past) const {
  return seen_ ? seen_->sightings[static_cast<std::size_t>(past)].get() : nullptr;
}

QString Sight::nameOf(std::size_t target) const {
  return workspace_.nameOf(seen_->around->buildings[target]);
}

/// Looks again where anything changed; shows nothing where nothing is asked for any more.
void Sight::follow() {
  if (!isWanted()) return forget();
  if (!isOutdated()) return;
  debounce_.start();
  Q_EMIT looking();
}

void Sight::forget() {
  debounce_.stop();
  if (workspace_.tasks().busy(task())) workspace_.tasks().cancel(task());
  if (placing_ && !hasTargets()) {
    placing_ = false;
    Q_EMIT placingChanged();
  }
  choose({});
  seen_.reset();
  Q_EMIT seenChanged();
}

void Sight::look() {
  if (!isOutdated()) return;
  workspace_.tasks().start(
      task(), tr("Looking from the viewpoint"),
      [staged = stage_.staged(), options = options(), models = models(), earlier = seen_](
          const Progress& progress) { return lookPast(*staged, options, models, earlier.get(), progress); },
      [this, staged = stage_.staged()](Seen seen) {
        if (stage_.staged() == staged && isWanted()) take(std::move(seen));
      });
}

void Sight::take(Seen seen) {
  if (!seen_ || seen_->around != seen.around) choose({});
  seen_ = std::make_shared<const Seen>(std::move(seen));
  Q_EMIT seenChanged();
}

void Sight::choose(std::optional<std::size_t> target) {
  if (target == target_) return;
  target_ = target;
  Q_EMIT targetChanged();
}

void Sight::flyTo(std::size_t target) {
  const Box3 box = boxOf(*seen_->around, target);
  choose(target);
  if (!box.empty()) stage_.flyTo(box);
}

}  // namespace lodestone
