#include "gui/perception/perceiving.h"

#include <QPointer>
#include <algorithm>
#include <utility>

#include "algorithms/perception/viewpoints.h"

namespace lodestone {
namespace {

constexpr int kDebounceMs = 300;
constexpr double kMostSeconds = 60;  // of a look that nobody asked for
constexpr double kMostGibibytes = 1;
/// Until one was timed: 26 views of 1024² in 12 s.
constexpr double kUsualSecondsAPixel = 12 / (26.0 * 1024 * 1024);
/// Fewer do not say what a pixel takes: most of their time is that of beginning.
constexpr double kTimedPixels = 4.0 * 1024 * 1024;

const QString kJudgeTask = QStringLiteral("perceive-judge");

}  // namespace

Perceiving::Perceiving(Stage& stage, Workspace& workspace, QObject* parent)
    : QObject(parent), stage_(stage), workspace_(workspace), secondsAPixel_(kUsualSecondsAPixel) {
  debounce_.setSingleShot(true);
  debounce_.setInterval(kDebounceMs);
  connect(&debounce_, &QTimer::timeout, this, [this] {
    if (!isLarge()) look();
    Q_EMIT looking();
  });
  for (const auto change : {&Stage::opening, &Stage::closed})
    connect(&stage_, change, this, &Perceiving::forget);
  connect(&stage_, &Stage::opened, this, [this] {
    Q_EMIT camerasChanged();
    follow();
  });
  for (const auto change : {&Stage::optionsChanged, &Stage::comparingChanged})
    connect(&stage_, change, this, &Perceiving::follow);
  connect(&stage_, &Stage::picturesWanted, this, [this] {
    if (isLooking() || debounce_.isActive()) return;
    isLarge() ? Q_EMIT consentWanted() : look();
  });
  connect(&workspace_, &Workspace::stateChanged, this,
          [this](const ProjectState& before, const ProjectState& after) {
            if (before.perceiveOptions != after.perceiveOptions) onOptions(before.perceiveOptions);
          });
  connect(&workspace_.tasks(), &TaskRunner::finished, this, [this](const QString& key, bool committed) {
    if (key == Stage::picturesTask()) {
      // The end of a look at a building that is gone says nothing about the next one.
      if (std::exchange(forgetting_, false))
        follow();
      else
        stopped_ = !committed;
      Q_EMIT looking();
    } else if (key == kJudgeTask) {
      if (committed) judge();  // cuts may have moved on; what failed would fail again, and for ever
      Q_EMIT looking();
    }
  });
}

const PerceiveOptions& Perceiving::options() const {
  return workspace_.state().perceiveOptions;
}

void Perceiving::setOptions(const PerceiveOptions& options, const QString& what) {
  workspace_.setPerceiveOptions(options, what);
}

void Perceiving::onOptions(const PerceiveOptions& before) {
  if (samePictures(before, options())) {
    judge();
  } else {
    stopped_ = false;
    Q_EMIT camerasChanged();
    follow();
  }
  Q_EMIT optionsChanged();
}

void Perceiving::setWatched(bool watched) {
  if (watched == watched_) return;
  watched_ = watched;
  follow();
}

std::vector<Camera> Perceiving::cameras() const {
  if (!canLook()) return {};
  std::vector<Camera> all = viewpointsAround(bounds(*stage_.staged()->mesh), options());
  for (Camera camera : added_) {
    camera.width = camera.height = options().size;
    all.push_back(camera);
  }
  return all;
}

void Perceiving::addCamera(const Camera& camera) {
  added_.push_back(camera);
  stopped_ = false;
  Q_EMIT camerasChanged();
  choose(cameras().size() - 1);
  follow();
}

bool Perceiving::isAdded(std::size_t view) const {
  const std::size_t count = cameras().size();
  return view < count && view >= count - std::min(count, added_.size());
}

void Perceiving::removeCamera(std::size_t view) {
  if (!isAdded(view)) return;
  const std::size_t first = cameras().size() - added_.size();
  added_.erase(added_.begin() + static_cast<std::ptrdiff_t>(view - first));
  Q_EMIT camerasChanged();
  choose(std::min(view_, cameras().size() - 1));
  follow();
}

const QImage& Perceiving::thumbnail(std::size_t view) const {
  static const QImage none;
  return view < thumbnails_.size() ? thumbnails_[view] : none;
}

bool Perceiving::canLook() const {
  return stage_.isOpen() && stage_.staged()->mesh->triangleCount() > 0;
}

bool Perceiving::isWanted() const {
  return canLook() && (watched_ || stage_.needsPictures());
}

bool Perceiving::isOutdated() const {
  return canLook() && (!looked_ || !samePictures(looked_->perception->options, options()) ||
                       looked_->perception->cameras != cameras());
}

bool Perceiving::isLeftUnjudged() const {
  return looked_ && !isOutdated() && !(looked_->perception->options == options()) &&
         !workspace_.tasks().busy(kJudgeTask);
}

bool Perceiving::isLooking() const {
  return workspace_.tasks().busy(Stage::picturesTask());
}

double Perceiving::seconds() const {
  const double size = options().size;
  return secondsAPixel_ * size * size * static_cast<double>(cameras().size());
}

double Perceiving::gibibytes() const {
  const std::size_t triangles = canLook() ? stage_.staged()->mesh->triangleCount() : 0;
  return perceivingMemory(cameras(), triangles) / (1024.0 * 1024 * 1024);
}

bool Perceiving::isLarge() const {
  return seconds() > kMostSeconds || gibibytes() > kMostGibibytes;
}

void Perceiving::follow() {
  if (isWanted() && isOutdated() && !stopped_) debounce_.start();
  Q_EMIT looking();
}

void Perceiving::forget() {
  debounce_.stop();
  forgetting_ = forgetting_ || workspace_.tasks().busy(Stage::picturesTask());
  // What is being judged ends soon, is dropped then, and makes way for the next.
  if (workspace_.tasks().busy(Stage::picturesTask())) workspace_.tasks().cancel(Stage::picturesTask());
  ++run_;
  stopped_ = false;
  looked_.reset();
  thumbnails_.clear();
  added_.clear();
  view_ = 0;
  Q_EMIT camerasChanged();
  Q_EMIT lookedChanged();
}

void Perceiving::cancel() {
  debounce_.stop();
  if (isLooking()) workspace_.tasks().cancel(Stage::picturesTask());
}

void Perceiving::look() {
  debounce_.stop();
  if (isLeftUnjudged()) return judge();
  if (!canLook() || !isOutdated()) return;
  stopped_ = false;
  ++run_;
  made_ = 0;
  const std::vector<Camera> all = cameras();
  thumbnails_.resize(all.size());
  // Small pictures come through the task runner, which lives as long as its threads do.
  const ThumbnailSink sink = [runner = &workspace_.tasks(), self = QPointer(this), run = run_](
                                 std::size_t view, const QImage& picture) {
    QMetaObject::invokeMethod(
        runner,
        [self, run, view, picture] {
          if (self) self->takeThumbnail(run, view, picture);
        },
        Qt::QueuedConnection);
  };
  workspace_.tasks().start(
      Stage::picturesTask(), tr("Looking from %n viewpoints", nullptr, static_cast<int>(all.size())),
      [staged = stage_.staged(), earlier = looked_, all, options = options(),
       sink](const Progress& progress) { return lookAt(staged, earlier, all, options, sink, progress); },
      [this, staged = stage_.staged()](Looked looked) {
        if (stage_.isOpen() && stage_.staged()->mesh == staged->mesh) take(std::move(looked));
      });
  Q_EMIT looking();
}

void Perceiving::takeThumbnail(unsigned run, std::size_t view, const QImage& picture) {
  if (run != run_ || view >= thumbnails_.size()) return;
  thumbnails_[view] = picture;
  ++made_;
  Q_EMIT thumbnailMade(view);
}

void Perceiving::take(Looked looked) {
  if (!looked.diagnostics.empty()) Q_EMIT workspace_.diagnosed(looked.diagnostics);
  const Perception& seen = *looked.perception;
  const double size = seen.options.size;
  const double pixels = size * size * static_cast<double>(seen.cameras.size());
  if (pixels >= kTimedPixels) secondsAPixel_ = looked.seconds / pixels;
  looked_ = std::make_shared<const Looked>(std::move(looked));
  stage_.setPerception(looked_->perception);
  Q_EMIT lookedChanged();
  isOutdated() ? follow() : judge();
}

/// One at a time: whoever drags a cut sees what came of it on the way.
void Perceiving::judge() {
  if (!looked_ || looked_->perception->options == options() || isOutdated()) return;
  if (workspace_.tasks().busy(kJudgeTask)) return;
  workspace_.tasks().start(
      kJudgeTask, tr("Judging by other thresholds"),
      [looked = *looked_, options = options()](const Progress&) { return judgeAgain(looked, options); },
      [this, before = looked_](Looked looked) {
        if (looked_ != before) return;
        looked_ = std::make_shared<const Looked>(std::move(looked));
        stage_.setPerception(looked_->perception);
        Q_EMIT lookedChanged();
      });
}

void Perceiving::choose(std::size_t view) {
  if (view == view_ || view >= cameras().size()) return;
  view_ = view;
  Q_EMIT viewChanged();
}

}  // namespace lodestone
