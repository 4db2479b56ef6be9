#include "cli/perceive_flags.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "algorithms/perception/perceiving.h"

namespace lodestone::cli {
namespace {

constexpr double kBytesOfKeptPixel = 9.0 / 8;  // a bin, and whether it shows the model
/// A thread's, in a second (resources/docs/benchmarks.md).
constexpr double kPixelsPerSecond = 2e6;

/// One digit: it depends on the model and on the machine.
std::string aboutTime(double seconds) {
  const bool hours = seconds > 5400;
  const double count = hours ? seconds / 3600 : seconds / 60;
  return fmt::format("{:.{}f} {}", count, count < 1 ? 1 : 0, hours ? "hours" : "minutes");
}

/// About half a minute of two threads, and what a small computer has.
constexpr double kManyPixels = 1e8;
constexpr double kManyBytes = 4.0 * 1024 * 1024 * 1024;

}  // namespace

void addPerceiveFlags(CLI::App& app, PerceiveOptions& options) {
  addFlags(app, options);
  app.get_option("--size")->transform([](const std::string& text) {
    const std::size_t times = text.find('x');
    const bool square = times != std::string::npos && text.substr(0, times) == text.substr(times + 1);
    return square ? text.substr(0, times) : text;
  });
}

void refuseGiven(const CLI::App& command, const std::vector<std::string>& flags, const std::string& why) {
  for (const std::string& flag : flags) {
    const CLI::Option* option = command.get_option_no_throw(flag);
    if (option && option->count() > 0)
      throw Failure(diagnose(Code::OptionsContradict, fmt::format("{} {}", flag, why)));
  }
}

void requireRisingThresholds(const PerceiveOptions& options) {
  const std::array<std::pair<const char*, double>, 3> named{
      {{"--slight", options.slight}, {"--moderate", options.moderate}, {"--dramatic", options.dramatic}}};
  std::pair<const char*, double> last{"", 0};
  for (const auto& threshold : named) {
    if (threshold.second <= 0) continue;
    if (threshold.second < last.second)
      throw Failure(diagnose(Code::OptionBadValue,
                             fmt::format("{} {} is below {} {}: a class begins where the lesser one ends",
                                         threshold.first, threshold.second, last.first, last.second)));
    last = threshold;
  }
}

LookingCost lookingCost(const std::vector<Camera>& cameras, std::size_t triangles, int threads, bool kept,
                        std::size_t models) {
  LookingCost cost;
  for (const Camera& camera : cameras) cost.pixels += static_cast<double>(camera.width) * camera.height;
  cost.pixels *= static_cast<double>(models);
  cost.seconds = cost.pixels / (kPixelsPerSecond * threads);
  const std::size_t sideBySide = std::min(models, static_cast<std::size_t>(threads));
  cost.bytes =
      perceivingMemory(cameras, triangles, sideBySide) + (kept ? kBytesOfKeptPixel * cost.pixels : 0);
  return cost;
}

void tellCost(Run& run, const LookingCost& cost, const std::string& what) {
  if (cost.pixels < kManyPixels && cost.bytes < kManyBytes) return;
  constexpr double kMebibyte = 1024 * 1024;
  run.sayAtOnce(diagnose(Code::LookingTakesLong,
                         fmt::format("{}: {:.0f} million, about {} and {:.0f} MiB", what, cost.pixels / 1e6,
                                     aboutTime(cost.seconds), cost.bytes / kMebibyte)));
}

}  // namespace lodestone::cli
