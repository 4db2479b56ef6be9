// One run of the command line: progress bar, timed stages, messages, report, exit status.
#pragma once

#include <chrono>
#include <exception>
#include <memory>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "model/progress.h"
#include "model/result.h"

namespace lodestone::cli {

struct CommonOptions {
  int threads = 0;  ///< 0: all cores
  std::string report;
  bool quiet = false;
  bool verbose = false;
};

/// Threads that work side by side.
[[nodiscard]] int threadsOf(const CommonOptions& options);

enum ExitStatus { kDone = 0, kFailed = 1, kWrongUsage = 2, kDoneWithLosses = 3, kInterrupted = 130 };

/// Ends a command that cannot go on; the diagnostics say why.
class Failure : public std::exception {
 public:
  explicit Failure(Diagnostics diagnostics) : diagnostics_(std::move(diagnostics)) {}
  explicit Failure(Diagnostic diagnostic) : diagnostics_{std::move(diagnostic)} {}
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }
  [[nodiscard]] const char* what() const noexcept override { return "failed"; }

 private:
  Diagnostics diagnostics_;
};

class Run {
 public:
  Run(std::string command, const CommonOptions& options, std::stop_token stop);

  /// Runs `work(progress)` as a timed stage of the report and returns what it returns.
  template <class Work>
  auto stage(const std::string& name, Work&& work) {
    const StageTimer timer(*this, name);
    const Progress progress = Progress(bar_, stop_).part(0, 1, name);  // its own: progress never falls
    auto result = work(progress);
    progress.checkpoint();
    return result;
  }
  /// The value of a result, its diagnostics said. \throw Failure when it has none.
  template <class T>
  T take(Result<T> result) {
    if (!result) throw Failure(std::move(result.diagnostics));
    add(std::move(result.diagnostics));
    return std::move(*result.value);
  }
  void add(Diagnostics diagnostics);
  /// While a command reads one input of several: what a message without a place is about.
  void setSubject(std::string subject) { subject_ = std::move(subject); }
  /// A note that is of use before the work begins: printed at once, and in the report.
  void sayAtOnce(const Diagnostic& note);
  [[nodiscard]] const CommonOptions& options() const { return options_; }

  nlohmann::ordered_json input = nlohmann::ordered_json::object();
  nlohmann::ordered_json output = nlohmann::ordered_json::object();
  nlohmann::ordered_json figures = nlohmann::ordered_json::object();

  /// Prints the messages, writes the report, gives the exit status.
  [[nodiscard]] int finish(ExitStatus status);

 private:
  class StageTimer {
   public:
    StageTimer(Run& run, std::string name);
    ~StageTimer();
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

   private:
    Run& run_;
    std::string name_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  };
  void printMessages() const;
  void writeReport() const;

  std::string command_;
  CommonOptions options_;
  Progress::Report bar_;
  std::stop_token stop_;
  std::string subject_;
  Diagnostics diagnostics_;
  std::set<Code> said_;  ///< notes that were printed at once
  nlohmann::ordered_json stages_ = nlohmann::ordered_json::array();
};

}  // namespace lodestone::cli
