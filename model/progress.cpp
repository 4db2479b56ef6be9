#include "model/progress.h"

#include <algorithm>

namespace lodestone {
namespace {
constexpr double kSmallestStep = 1e-3;
}

Progress::Progress(Report report, std::stop_token stop) : stop_(std::move(stop)) {
  if (!report) return;
  sink_ = std::make_shared<Sink>();
  sink_->report = std::move(report);
}

Progress Progress::part(double begin, double end, std::string stage) const {
  Progress result = *this;
  result.begin_ = begin_ + (end_ - begin_) * begin;
  result.end_ = begin_ + (end_ - begin_) * end;
  if (!stage.empty()) result.stage_ = std::move(stage);
  result.report(0);
  return result;
}

void Progress::report(double done) const {
  if (!sink_) return;
  const double whole = begin_ + (end_ - begin_) * std::clamp(done, 0.0, 1.0);
  const std::lock_guard lock(sink_->mutex);
  const bool newStage = stage_ != sink_->lastStage;
  const bool finished = whole >= 1 && sink_->last < 1;
  if (whole < sink_->last || (!newStage && !finished && whole - sink_->last < kSmallestStep)) return;
  sink_->last = whole;
  sink_->lastStage = stage_;
  sink_->report(whole, stage_);
}

void Progress::checkpoint() const {
  if (stop_.stop_requested()) throw Cancelled();
}

}  // namespace lodestone
