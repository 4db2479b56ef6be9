// Clustering against a plain trial of the same idea, on a made-up city with the counts of table 1 in Chang et
// al. 2008.
//
// usage: clustering_benchmark [--growth MOST_BUILDINGS] [--floor PROGRAM]
//
// PROGRAM is an external trial that takes the number of buildings and is timed beside it.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "algorithms/clustering/clustering.h"
#include "algorithms/synthesis/synthesis.h"

#include "measuring.h"
#include "plain_trial.h"

namespace lodestone {
namespace {

constexpr int kNeighbours = 50;

FootprintTable city(CityPreset preset, int buildings) {
  return footprintTable(synthesiseCity({.preset = preset, .buildings = buildings}));
}

struct Run {
  double time = 0;
  double processor = 0;
  double mebibytes = 0;
  std::uint32_t depth = 0;
};

Run cluster(const FootprintTable& table, Linkage linkage) {
  Run run;
  resetPeak();
  const double before = memory("VmRSS");
  const double processor = processorSeconds();
  run.time = seconds(
      [&] { run.depth = makeDendrogram(table, {.linkage = linkage, .neighbours = kNeighbours}).depth; });
  run.processor = processorSeconds() - processor;
  run.mebibytes = memory("VmHWM") - before;
  return run;
}

void compare(const char* name, CityPreset preset, const char* paper, const char* paperDepth,
             const std::string& floor) {
  const FootprintTable table = city(preset, 0);
  const Run run = cluster(table, Linkage::Legible);
  const double processor = processorSeconds();
  const double plain = seconds([&] { (void)runPlainTrial(table); });
  const double plainProcessor = processorSeconds() - processor;
  const Run single = cluster(table, Linkage::Single);
  std::printf(
      "%-10s %9zu %10zu | %8.2f s %8.2f s  ratio %5.2f | %6.0f MiB | depth %4u, single-link %5u | paper: %s, "
      "depth %s\n",
      name, table.buildingCount(), table.vertices.size(), run.time, plain, run.time / plain, run.mebibytes,
      run.depth, single.depth, paper, paperDepth);
  std::printf("%-10s processor time, all threads: %.2f s and %.2f s\n", name, run.processor, plainProcessor);
  std::fflush(stdout);
  if (floor.empty()) return;
  const std::string command = floor + " " + std::to_string(table.buildingCount()) + " > /dev/null";
  int status = 0;
  const double external = seconds([&] { status = std::system(command.c_str()); });
  if (status == 0)
    std::printf("%-10s external trial %.2f s, its making of a city included: ratio %.2f\n", name, external,
                run.time / external);
}

struct Growth {
  Run large;
  double small = 0;  ///< time, s
  [[nodiscard]] double factor() const { return large.time / small; }
};

/// The time of four times as many buildings against that of the small city just before and just after, median
/// of some rounds: a machine that others use too is faster at one minute than at the next.
Growth growthTo(const FootprintTable& small, const FootprintTable& large) {
  std::vector<Growth> rounds(large.buildingCount() < 1'000'000 ? 5 : 3);
  double before = cluster(small, Linkage::Legible).time;
  for (Growth& round : rounds) {
    round.large = cluster(large, Linkage::Legible);
    const double after = cluster(small, Linkage::Legible).time;
    round.small = (before + after) / 2;
    before = after;
  }
  std::sort(rounds.begin(), rounds.end(),
            [](const Growth& a, const Growth& b) { return a.factor() < b.factor(); });
  return rounds[rounds.size() / 2];
}

void grow(int most) {
  std::printf("\ngrowth: buildings x 4 -> time x at most 4.8\n");
  FootprintTable small = city(CityPreset::Charlotte, 92482);
  for (int n = 4 * 92482; n <= most; n *= 4) {
    FootprintTable large = city(CityPreset::Charlotte, n);
    const Growth growth = growthTo(small, large);
    std::printf("%9d buildings %8.2f s  x %.2f of %.2f s  %6.0f MiB\n", n, growth.large.time, growth.factor(),
                growth.small, growth.large.mebibytes);
    std::fflush(stdout);
    small = std::move(large);
  }
}

}  // namespace
}  // namespace lodestone

int main(int argc, char** argv) {
  using namespace lodestone;
  int most = 1500000;
  std::string floor;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::string(argv[i]) == "--growth") most = std::atoi(argv[i + 1]);
    if (std::string(argv[i]) == "--floor") floor = argv[i + 1];
  }
  std::printf("city       buildings   vertices |  Lodestone plain trial              |     memory |\n");
  compare("xinxiang", CityPreset::Xinxiang, "8 min", "not given", floor);
  compare("charlotte", CityPreset::Charlotte, "102 min", "170, single-link 726", floor);
  grow(most);
  return 0;
}
