// ꟻLIP of two pictures of 1920 × 1080 pixels at 67 pixels per degree, with one thread and with two. The time
// of all threads together stands beside the time of the wall, for machines that others use too.
#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "algorithms/perception/flip.h"

#include "measuring.h"

namespace lodestone {
namespace {

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;
constexpr int kRuns = 5;

/// Slow waves, and noise on them.
Picture picture(unsigned seed) {
  std::mt19937 random(seed);
  Picture result{kWidth, kHeight, {}};
  result.rgba.reserve(4UL * kWidth * kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (int c = 0; c < 4; ++c)
        result.rgba.push_back(
            static_cast<std::uint8_t>((x / (c + 3) + y / 5) % 240 + static_cast<int>(random() % 16)));
    }
  }
  return result;
}

void run() {
  const Picture a = picture(1);
  const Picture b = picture(2);
  fmt::print("{:>7} {:>12} {:>16} {:>10}\n", "threads", "least wall s", "processor s each", "mean");
  for (const std::size_t threads : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    double wall = 1e9;
    double mean = 0;
    const double before = processorSeconds();
    for (int i = 0; i < kRuns; ++i) wall = std::min(wall, seconds([&] { mean = flip(a, b, 67).mean; }));
    fmt::print("{:>7} {:>12.3f} {:>16.3f} {:>10.6f}\n", threads, wall, (processorSeconds() - before) / kRuns,
               mean);
  }
}

}  // namespace
}  // namespace lodestone

int main() {
  lodestone::run();
}
