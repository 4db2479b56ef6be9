// Progress and cancel as one cheap value.
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

namespace lodestone {

/// Thrown by Progress::checkpoint() when a stop was asked for. Caught in one place: where the task was
/// started.
class Cancelled : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

/// A window [begin, end] on one progress bar, and a stop token shared by all its parts. Copies are cheap and
/// refer to the same bar. A default Progress reports nowhere and never stops.
///
/// Inside a parallel body use stopRequested() and leave the loop, then call checkpoint() outside: nothing may
/// throw in a worker thread.
class Progress {
 public:
  /// Called with the share done (0–1, never falling) and the stage; from any thread, one call at a time.
  using Report = std::function<void(double done, const std::string& stage)>;

  Progress() = default;
  explicit Progress(Report report, std::stop_token stop = {});

  /// The part of this window from `begin` to `end` (0–1), named `stage` (empty: keeps the name).
  [[nodiscard]] Progress part(double begin, double end, std::string stage = {}) const;
  /// Says that `done` (0–1) of this window is done. Cheap: reports that would not move the bar by 0.1% are
  /// dropped.
  void report(double done) const;
  [[nodiscard]] bool stopRequested() const { return stop_.stop_requested(); }
  /// \throw Cancelled if a stop was asked for.
  void checkpoint() const;
  [[nodiscard]] std::stop_token stopToken() const { return stop_; }

 private:
  struct Sink {
    Report report;
    std::mutex mutex;
    double last = -1;
    std::string lastStage;
  };
  std::shared_ptr<Sink> sink_;
  std::stop_token stop_;
  double begin_ = 0;
  double end_ = 1;
  std::string stage_;
};

}  // namespace lodestone
