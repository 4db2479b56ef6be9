// Merged hulls of made-up Charlottes against clustering the same buildings in the same run, their growth with
// the number of buildings, and cuts from many cameras. Arguments: numbers of buildings (default 92,482 and
// the paper's 369,929).
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <numbers>

#include <fmt/format.h>
#include <sys/resource.h>

#include "algorithms/clustering.h"
#include "algorithms/cutting.h"
#include "algorithms/merging.h"
#include "algorithms/synthesis.h"

namespace lodestone {
namespace {

/// Processor time of all threads so far, s: what a busy machine does not falsify.
double seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Most memory used so far, MiB.
double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

struct CutTimes {
  double median = 0;
  double worst = 0;
  double drawn = 0;  ///< mean number of nodes
};

/// Milliseconds of cuts from a walk round the city: at street level, above the roofs, and from far above.
CutTimes cutTimes(const ClusterTree& tree) {
  const ClusterNode& root = tree.nodes.back();
  const Vec2 centre = root.box.center();
  const double radius = root.box.size().norm() / 2;
  std::vector<double> times;
  double drawn = 0;
  for (const double reach : {0.1, 0.5, 1.0}) {
    for (const double height : {0.0005, 0.01, 0.1, 0.7}) {
      for (int step = 0; step < 12; ++step) {
        const double angle = step * std::numbers::pi / 6;
        Camera camera;
        camera.eye << centre + reach * radius * Vec2(std::cos(angle), std::sin(angle)), 2 + height * radius;
        camera.target << centre, 0;
        const double begin = seconds();
        const Cut cut = makeCut(tree, {}, camera);
        times.push_back((seconds() - begin) * 1000);
        drawn += static_cast<double>(cut.drawn.size());
      }
    }
  }
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], times.back(), drawn / static_cast<double>(times.size())};
}

void run(const std::vector<int>& sizes) {
  fmt::print("{:>9} {:>8} {:>11} {:>9} {:>14} {:>8} {:>12} {:>13} {:>11} {:>8}\n", "buildings", "depth",
             "clust. CPU s", "merg. CPU", "merging/clust.", "growth", "MiB merging", "cut median ms",
             "cut worst", "drawn");
  double before = 0;
  int sizeBefore = 0;
  for (const int size : sizes) {
    const auto footprints = std::make_shared<const FootprintTable>(
        footprintTable(synthesiseCity({CityPreset::Charlotte, size, 1})));
    const double start = seconds();
    const auto dendrogram = std::make_shared<const Dendrogram>(makeDendrogram(*footprints, {}));
    const double clustered = seconds();
    const double memory = peakMemory();
    const ClusterTree tree = makeClusterTree(footprints, dendrogram);
    const double merging = seconds() - clustered;
    const CutTimes cuts = cutTimes(tree);
    const double growth = before > 0 ? merging / before / (static_cast<double>(size) / sizeBefore) : 1;
    fmt::print("{:>9} {:>8} {:>11.2f} {:>9.2f} {:>14.2f} {:>8.2f} {:>12.0f} {:>13.2f} {:>11.2f} {:>8.0f}\n",
               size, dendrogram->depth, clustered - start, merging, merging / (clustered - start), growth,
               peakMemory() - memory, cuts.median, cuts.worst, cuts.drawn);
    before = merging;
    sizeBefore = size;
  }
}

}  // namespace
}  // namespace lodestone

int main(int argc, char** argv) {
  std::vector<int> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::atoi(argv[i]));
  if (sizes.empty()) sizes = {92'482, 369'929};
  lodestone::run(sizes);
}
