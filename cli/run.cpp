#include "cli/run.h"

#include <cstdio>
#include <map>
#include <system_error>

#include <fmt/format.h>
#include <oneapi/tbb/info.h>
#include <sys/resource.h>
#include <unistd.h>

#include "model/io/atomic_file.h"

namespace lodestone::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kBarWidth = 30;
constexpr int kMessagesOfOneCode = 5;

void drawBar(double done, const std::string& stage) {
  const int filled = static_cast<int>(done * kBarWidth);
  fmt::print(stderr, "\r\033[K{:>12} [{:#<{}}{:.<{}}] {:3.0f}%", stage, "", filled, "", kBarWidth - filled,
             done * 100);
  if (done >= 1) fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

/// Largest resident size of the process so far, MiB.
double peakMebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

Json diagnosticJson(const Diagnostic& d) {
  Json json = {{"code", static_cast<int>(d.code)},
               {"severity", toString(d.severity)},
               {"object", d.object},
               {"text", d.text}};
  if (!d.place.empty()) json["place"] = d.place;
  return json;
}

/// With its place, where the text does not name that already.
std::string noteText(const Diagnostic& d) {
  const bool named = d.place.empty() || d.text.find(d.place) != std::string::npos;
  return fmt::format("note {}: {}{}", static_cast<int>(d.code), d.text,
                     named ? "" : fmt::format(" ({})", d.place));
}

/// The first few notes of a code, and how many more there are.
void printNotes(const Diagnostics& diagnostics, Code code) {
  int count = 0;
  for (const Diagnostic& d : diagnostics) {
    if (d.code == code && ++count <= kMessagesOfOneCode) fmt::print(stderr, "{}\n", noteText(d));
  }
  if (count > kMessagesOfOneCode)
    fmt::print(stderr, "note {}: {} more\n", static_cast<int>(code), count - kMessagesOfOneCode);
}

}  // namespace

int threadsOf(const CommonOptions& options) {
  return options.threads > 0 ? options.threads : oneapi::tbb::info::default_concurrency();
}

Run::Run(std::string command, const CommonOptions& options, std::stop_token stop)
    : command_(std::move(command)), options_(options), stop_(std::move(stop)) {
  if (!options.quiet && isatty(STDERR_FILENO) != 0) bar_ = drawBar;
}

Run::StageTimer::StageTimer(Run& run, std::string name) : run_(run), name_(std::move(name)) {}

Run::StageTimer::~StageTimer() {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin_;
  run_.stages_.push_back({{"name", name_}, {"seconds", seconds.count()}, {"peak_mib", peakMebibytes()}});
}

void Run::add(Diagnostics diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.place.empty()) diagnostic.place = subject_;
  }
  diagnostics_.insert(diagnostics_.end(), std::make_move_iterator(diagnostics.begin()),
                      std::make_move_iterator(diagnostics.end()));
}

void Run::sayAtOnce(const Diagnostic& note) {
  add({note});
  said_.insert(note.code);
  if (options_.quiet) return;
  fmt::print(stderr, "{}. {}\n", noteText(note), info(note.code).advice);
  std::fflush(stderr);
}

void Run::printMessages() const {
  std::map<Code, int> printed;
  for (const Diagnostic& d : diagnostics_) {
    if (said_.contains(d.code)) continue;
    const bool wanted = options_.verbose || d.severity == Severity::Error ||
                        (d.severity == Severity::Warning && printed[d.code] < kMessagesOfOneCode);
    if (wanted) fmt::print(stderr, "{}\n", lodestone::format(d));
    if (!wanted || !options_.verbose) ++printed[d.code];
  }
  if (options_.verbose) return;
  for (const auto& [code, count] : printed) {
    const DiagnosticInfo& row = info(code);
    if (row.severity == Severity::Warning && count > kMessagesOfOneCode) {
      fmt::print(stderr, "{} more of warning {} ({}); --verbose or --report lists them\n",
                 count - kMessagesOfOneCode, static_cast<int>(code), row.title);
    } else if (row.severity == Severity::Info && !options_.quiet) {
      printNotes(diagnostics_, code);
    }
  }
}

void Run::writeReport() const {
  Json list = Json::array();
  for (const Diagnostic& d : diagnostics_) list.push_back(diagnosticJson(d));
  const Json report = {{"command", command_}, {"input", input},     {"output", output},
                       {"stages", stages_},   {"figures", figures}, {"diagnostics", list}};
  writeFile(options_.report, report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

int Run::finish(ExitStatus status) {
  const bool losses = std::any_of(diagnostics_.begin(), diagnostics_.end(),
                                  [](const Diagnostic& d) { return d.severity != Severity::Info; });
  if (status == kDone && losses) status = kDoneWithLosses;
  if (!options_.quiet && isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");
  printMessages();
  if (!options_.report.empty()) {
    try {
      writeReport();
    } catch (const std::system_error& error) {
      fmt::print(stderr, "{}\n", lodestone::format(diagnose(Code::OutputUnwritable, error.what())));
      return kFailed;
    }
  }
  return status;
}

}  // namespace lodestone::cli
