#include "gui/perception/comparing.h"

#include <QPointer>
#include <algorithm>

#include "algorithms/perception/viewpoints.h"

namespace lodestone {
namespace {

constexpr int kDebounceMs = 400;
constexpr double kTurn =
    0.5;  // of the viewpoints that are measured from against those that are classified by

const QString kTask = QStringLiteral("compare");

}  // namespace

Comparing::Comparing(Perceiving& perceiving, Workspace& workspace, QObject* parent)
    : QObject(parent), perceiving_(perceiving), workspace_(workspace) {
  debounce_.setSingleShot(true);
  debounce_.setInterval(kDebounceMs);
  connect(&debounce_, &QTimer::timeout, this, &Comparing::update);
  for (const auto change : {&Perceiving::lookedChanged, &Perceiving::viewChanged})
    connect(&perceiving_, change, this, &Comparing::follow);
  connect(&perceiving_, &Perceiving::viewChanged, this, [this] { choose({}); });
  connect(&perceiving_.stage(), &Stage::levelChanged, this, &Comparing::follow);
  connect(&perceiving_.stage(), &Stage::comparingChanged, this, &Comparing::follow);
  connect(&workspace_.tasks(), &TaskRunner::finished, this, [this](const QString& key, bool committed) {
    if (key != kTask) return;
    stopped_ = !committed;
    if (committed && !measuring_) measure();  // what is looked at comes first
    Q_EMIT measuredChanged();
  });
}

void Comparing::setWatched(bool watched) {
  if (watched == watched_) return;
  watched_ = watched;
  follow();
}

void Comparing::choose(std::optional<std::size_t> view) {
  if (view == view_) return;
  view_ = view;
  Q_EMIT viewChanged();
  if (watched_ && original_) showView();
}

void Comparing::cancel() {
  debounce_.stop();
  if (workspace_.tasks().busy(kTask)) workspace_.tasks().cancel(kTask);
}

void Comparing::resume() {
  stopped_ = false;
  update();
}

bool Comparing::isBusy() const {
  return debounce_.isActive() || workspace_.tasks().busy(kTask);
}

/// Levels that went come off at once; the rest waits until nothing changes for a moment.
void Comparing::follow() {
  if (!perceiving_.looked()) {
    cancel();
    original_.reset();
    takeLevels();
    cameras_.clear();
    measured_.clear();
    pictures_.reset();
    view_.reset();
    Q_EMIT picturesChanged();
    Q_EMIT measuredChanged();
    return;
  }
  stopped_ = false;
  if (watched_) debounce_.start();
}

/// Scenes of levels that are the same as before stay.
void Comparing::takeLevels() {
  const Stage& stage = perceiving_.stage();
  for (const Stage::Method method : {Stage::A, Stage::B}) {
    const auto& level = stage.level(method);
    const bool shown = original_ && level && (method == Stage::A || stage.comparing());
    const auto simplified = shown ? level->simplified : nullptr;
    if (simplified == (levels_[method] ? levels_[method]->simplified() : nullptr)) continue;
    levels_[method] =
        simplified ? std::make_shared<const LevelScene>(simplified, perceiving_.looked()->look) : nullptr;
    for (LevelMeasures& measures : measured_) measures[method].reset();
  }
}

void Comparing::update() {
  const auto& looked = perceiving_.looked();
  if (!looked || stopped_) return;
  const PerceiveOptions& options = looked->perception->options;
  std::vector<Camera> cameras = viewpointsAround(bounds(*looked->staged->mesh), options, kTurn);
  if (original_ != looked->renderer || cameras != cameras_ || pixelsPerDegree_ != options.pixelsPerDegree()) {
    if (original_ != looked->renderer) levels_ = {};
    original_ = looked->renderer;
    pixelsPerDegree_ = options.pixelsPerDegree();
    cameras_ = std::move(cameras);
    measured_.assign(cameras_.size(), {});
    if (view_ && *view_ >= cameras_.size()) choose({});
  }
  takeLevels();
  Q_EMIT measuredChanged();
  showView();
}

std::optional<Camera> Comparing::camera() const {
  if (view_) return cameras_[*view_];
  const auto& cameras = perceiving_.looked()->perception->cameras;
  if (perceiving_.view() >= cameras.size()) return {};
  return cameras[perceiving_.view()];
}

bool Comparing::isShown() const {
  return pictures_ && pictures_->camera == camera() && pictures_->levels == levels_ &&
         pictures_->pixelsPerDegree == pixelsPerDegree_;
}

bool Comparing::isDone() const {
  if (!original_ || !isShown()) return false;
  return std::all_of(measured_.begin(), measured_.end(), [this](const LevelMeasures& measures) {
    return (!levels_[Stage::A] || measures[Stage::A]) && (!levels_[Stage::B] || measures[Stage::B]);
  });
}

void Comparing::showView() {
  const auto from = camera();
  if (!from || isShown()) return measure();
  measuring_ = false;
  ++run_;
  workspace_.tasks().start(
      kTask, tr("Comparing pictures"),
      [original = original_, levels = levels_, from = *from, pixels = pixelsPerDegree_](
          const Progress& progress) { return compareFrom(*original, levels, from, pixels, progress); },
      [this, original = original_](ComparedPictures made) {
        if (original != original_) return;
        pictures_ = std::make_shared<const ComparedPictures>(std::move(made));
        Q_EMIT picturesChanged();
      });
}

/// What is not measured yet.
void Comparing::measure() {
  if (!original_ || !watched_) return;
  std::vector<ViewToMeasure> views;
  for (std::size_t view = 0; view < cameras_.size(); ++view) {
    ViewToMeasure wanted{view, cameras_[view], levels_};
    bool any = false;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      if (measured_[view][i]) wanted.levels[i].reset();
      any = any || wanted.levels[i];
    }
    if (any) views.push_back(std::move(wanted));
  }
  if (views.empty()) return;
  measuring_ = true;
  ++run_;
  const MeasureSink sink = [runner = &workspace_.tasks(), self = QPointer(this), run = run_](
                               std::size_t view, const LevelMeasures& measures) {
    QMetaObject::invokeMethod(
        runner,
        [self, run, view, measures] {
          if (self) self->takeMeasures(run, view, measures);
        },
        Qt::QueuedConnection);
  };
  workspace_.tasks().start(
      kTask, tr("Measuring how different it looks"),
      [original = original_, views, pixels = pixelsPerDegree_, sink](const Progress& progress) {
        measureViews(*original, views, pixels, sink, progress);
        return views.size();
      },
      [](std::size_t) {});
}

void Comparing::takeMeasures(unsigned run, std::size_t view, const LevelMeasures& measures) {
  if (run != run_ || view >= measured_.size()) return;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (measures[i]) measured_[view][i] = measures[i];
  }
  Q_EMIT measuredChanged();
}

/// All views have as many pixels; of those that show a model each has its share.
Comparing::Pooled Comparing::pooled(Stage::Method method) const {
  Pooled pooled;
  for (const LevelMeasures& measures : measured_) {
    if (!measures[method]) continue;
    const PictureMeasures& one = *measures[method];
    pooled.mean.flip += one.flip;
    pooled.mean.flipShown += one.flipShown * one.shown;
    pooled.mean.pixelError += one.pixelError;
    pooled.mean.shown += one.shown;
    ++pooled.views;
  }
  if (pooled.views == 0) return pooled;
  const auto views = static_cast<double>(pooled.views);
  pooled.mean.flip /= views;
  pooled.mean.pixelError /= views;
  if (pooled.mean.shown > 0) pooled.mean.flipShown /= pooled.mean.shown;
  pooled.mean.shown /= views;
  return pooled;
}

}  // namespace lodestone
