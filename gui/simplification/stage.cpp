#include "gui/simplification/stage.h"

#include <algorithm>

#include "algorithms/chains/chain_building.h"
#include "algorithms/simplification/city_simplification.h"
#include "gui/simplification/stage_jobs.h"

namespace lodestone {
namespace {

constexpr int kDebounceMs = 120;
/// What is flown to is shown with this much of the building around it, in diagonals.
constexpr double kRoomAroundContact = 0.06;

}  // namespace

Stage::Stage(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
  debounce_.setSingleShot(true);
  debounce_.setInterval(kDebounceMs);
  connect(&debounce_, &QTimer::timeout, this, &Stage::compute);
  connect(&workspace_, &Workspace::stateChanged, this, &Stage::onStateChanged);
  connect(&workspace_.tasks(), &TaskRunner::started, this, &Stage::computingChanged);
  connect(&workspace_.tasks(), &TaskRunner::finished, this, [this](const QString& key, bool committed) {
    if (key == openTask() && !committed && isOpening()) close();  // stopped before there was anything
    Q_EMIT computingChanged();
  });
}

Stage::~Stage() = default;

QString Stage::methodTask(Method method) {
  return method == A ? QStringLiteral("simplify-a") : QStringLiteral("simplify-b");
}

QString Stage::title() const {
  const QString name = workspace_.nameOf(building_);
  const std::size_t others = staged_ ? staged_->buildings.size() - 1 : 0;
  return others == 0 ? name : tr("%1 and %n touching it", nullptr, static_cast<int>(others)).arg(name);
}

void Stage::onStateChanged(const ProjectState& before, const ProjectState& after) {
  if (before.city != after.city) {
    if (building_ != kNoNode) close();
    return;
  }
  const bool changed =
      before.simplifyOptions != after.simplifyOptions || before.comparedOptions != after.comparedOptions;
  if (!changed) return;
  if (staged_ && staged_->classes->gap != options(A).gap) {
    classifyAgain();
  } else if (isLive()) {
    debounce_.start();
  }
  Q_EMIT optionsChanged();
}

void Stage::open(NodeId building, bool withTouching) {
  const auto city = workspace_.state().city;
  if (!city || building >= city->buildings.size()) return;
  cancel();
  building_ = building;
  withTouching_ = withTouching;
  told_ = false;
  staged_.reset();
  perception_.reset();
  forgetLevels();
  Q_EMIT opening();
  classifyAgain();
}

void Stage::classifyAgain() {
  workspace_.tasks().start(
      openTask(), tr("Classifying %1").arg(workspace_.nameOf(building_)),
      [city = workspace_.state().city, building = building_, touching = withTouching_, known = staged_,
       gap = options(A).gap](const Progress& progress) -> Result<StagedBuilding> {
        if (known) return classifyStaged(*known, gap, progress);
        return stageBuilding(city, building, touching, gap, progress);
      },
      [this, city = workspace_.state().city, building = building_](Result<StagedBuilding> result) {
        if (workspace_.state().city != city || building_ != building) return;
        if (!told_ && !result.diagnostics.empty()) Q_EMIT workspace_.diagnosed(result.diagnostics);
        told_ = true;  // the gap changes nothing of it
        if (result) take(std::move(*result));
      });
}

void Stage::take(StagedBuilding staged) {
  forgetLevels();
  staged_ = std::make_shared<const StagedBuilding>(std::move(staged));
  Q_EMIT opened();
  if (staged_->classes->gap != options(A).gap) {  // undone while it was classified
    classifyAgain();
  } else if (isLive()) {
    compute();
  }
}

void Stage::forgetLevels() {
  debounce_.stop();
  awaitsPictures_ = false;
  for (auto& level : levels_) level.reset();
  selection_.clear();
  hover_ = kNoNode;
  vertex_.reset();
  contact_.reset();
}

void Stage::close() {
  cancel();
  building_ = kNoNode;
  staged_.reset();
  perception_.reset();
  forgetLevels();
  Q_EMIT closed();
}

void Stage::cancel() {
  debounce_.stop();
  for (const QString& key : {openTask(), methodTask(A), methodTask(B)}) {
    if (workspace_.tasks().busy(key)) workspace_.tasks().cancel(key);
  }
}

const SimplifyOptions& Stage::options(Method method) const {
  return method == A ? workspace_.state().simplifyOptions : workspace_.state().comparedOptions;
}

void Stage::setOptions(Method method, const SimplifyOptions& options, const QString& what) {
  workspace_.setSimplifyOptions(method == B, options, what);
}

void Stage::setComparing(bool comparing) {
  if (comparing == comparing_) return;
  comparing_ = comparing;
  if (comparing && isLive()) compute();
  Q_EMIT comparingChanged();
}

bool Stage::isLive() const {
  return staged_ && staged_->mesh->triangleCount() <= kMostLiveTriangles;
}

bool Stage::isOutdated(Method method) const {
  if (!staged_) return false;
  const auto& level = levels_[method];
  if (!level || level->options != options(method)) return true;
  return needsPerception(level->options.method) && level->perception != perception_;
}

bool Stage::needsPictures() const {
  return staged_ &&
         (needsPerception(options(A).method) || (comparing_ && needsPerception(options(B).method)));
}

void Stage::setPerception(std::shared_ptr<const Perception> perception) {
  if (perception == perception_) return;
  perception_ = std::move(perception);
  if (perception_ && needsPictures() && (isLive() || awaitsPictures_)) debounce_.start();
  if (perception_) awaitsPictures_ = false;
  Q_EMIT perceptionChanged();
}

bool Stage::isUnfinished(Method method) const {
  return staged_ && (isOutdated(method) || !levels_[method]->report);
}

bool Stage::isComputing(Method method) const {
  return workspace_.tasks().busy(methodTask(method));
}

bool Stage::isStopped() const {
  if (debounce_.isActive() || workspace_.tasks().busy(openTask())) return false;
  if (needsPictures() && workspace_.tasks().busy(picturesTask())) return false;
  bool unfinished = false;
  for (const Method method : {A, B}) {
    if (isComputing(method)) return false;
    unfinished = unfinished || ((method == A || comparing_) && isUnfinished(method));
  }
  return unfinished;
}

void Stage::compute() {
  debounce_.stop();
  for (const Method method : {A, B}) {
    if (method == B && !comparing_) continue;
    if (isOutdated(method)) {
      start(method);
    } else if (isUnfinished(method) && !isComputing(method)) {
      measure(method);  // stopped before
    }
  }
}

void Stage::start(Method method) {
  const SimplifyOptions wanted = options(method);
  const bool asks = needsPerception(wanted.method);
  if (asks && !perception_) {
    awaitsPictures_ = true;
    Q_EMIT picturesWanted();
    return;
  }
  workspace_.tasks().start(
      methodTask(method), tr("Simplifying"),
      [staged = staged_, perception = asks ? perception_ : nullptr, wanted](const Progress& progress) {
        return makeStagedLevel(*staged, perception, wanted, progress);
      },
      [this, method, staged = staged_](StagedLevel level) {
        if (staged_ != staged) return;
        levels_[method] = std::move(level);
        if (!isOutdated(method)) {
          if (!levels_[method]->report) measure(method);
        } else if (isLive()) {
          debounce_.start();  // set back, or on, while it was made
        }
        Q_EMIT levelChanged(method);
      });
}

void Stage::measure(Method method) {
  workspace_.tasks().start(
      methodTask(method), tr("Measuring"),
      [staged = staged_, level = *levels_[method]](const Progress& progress) {
        return measureStagedLevel(*staged, level, progress);
      },
      [this, method, simplified = levels_[method]->simplified](SimplifyReport report) {
        if (!levels_[method] || levels_[method]->simplified != simplified) return;
        levels_[method]->report = std::move(report);
        Q_EMIT levelChanged(method);
      });
}

std::function<LodChain()> Stage::simplified(Method method) const {
  if (!levels_[method]) return {};
  SimplifyOptions used = levels_[method]->options;
  used.a = levels_[method]->a;
  const double error = levels_[method]->report ? levels_[method]->report->hausdorff : 0;
  const auto& seen = levels_[method]->perception;
  const PerceiveOptions perceive = seen ? seen->options : PerceiveOptions();
  return [staged = staged_, simplified = levels_[method]->simplified, used, error, perceive] {
    auto city = std::make_shared<const CityModel>(
        simplifiedBuildings(*staged->city, staged->buildings, simplified->mesh));
    return simplifiedChain(std::move(city), used, error, perceive);
  };
}

void Stage::select(std::vector<std::uint32_t> components) {
  std::sort(components.begin(), components.end());
  if (components == selection_) return;
  selection_ = std::move(components);
  Q_EMIT selectionChanged();
}

void Stage::setHover(std::uint32_t component) {
  if (component == hover_) return;
  hover_ = component;
  Q_EMIT hoverChanged();
}

void Stage::pickVertex(std::optional<std::uint32_t> vertex) {
  if (vertex == vertex_) return;
  vertex_ = vertex;
  Q_EMIT vertexChanged();
}

void Stage::chooseContact(std::optional<std::size_t> contact) {
  if (contact == contact_) return;
  contact_ = contact;
  Q_EMIT contactChanged();
}

void Stage::flyToComponent(std::uint32_t component) {
  if (staged_) flyTo(bounds(*staged_->mesh, staged_->mesh->components[component]));
}

void Stage::flyToContact(std::size_t contact) {
  for (const auto& level : levels_) {
    if (!level || !level->report || contact >= level->report->contacts.size()) continue;
    const Vec3& at = level->report->contacts[contact].at;
    const Vec3 room = Vec3::Constant(kRoomAroundContact * bounds(*staged_->mesh).size().norm());
    chooseContact(contact);
    return flyTo({at - room, at + room});
  }
}

}  // namespace lodestone
