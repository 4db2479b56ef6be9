// Merged hulls of made-up Charlottes against the plain trial and against clustering of the same buildings in
// the same run, their growth with the number of buildings, and cuts from many cameras. Arguments: numbers of
// buildings (default 92,482 and the paper's 369,929).
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "algorithms/clustering/clustering.h"
#include "algorithms/merging/cutting.h"
#include "algorithms/merging/merging.h"
#include "algorithms/synthesis/synthesis.h"

#include "measuring.h"
#include "plain_trial.h"

namespace lodestone {
namespace {

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
        Cut cut;
        times.push_back(1000 * seconds([&] { cut = makeCut(tree, {}, camera); }));
        drawn += static_cast<double>(cut.drawn.size());
      }
    }
  }
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], times.back(), drawn / static_cast<double>(times.size())};
}

void run(const std::vector<int>& sizes) {
  fmt::print("{:>9} {:>8} {:>13} {:>12} {:>11} {:>8} {:>12} {:>8} {:>12} {:>13} {:>11} {:>8}\n", "buildings",
             "depth", "plain trial s", "clustering s", "merging s", "/ trial", "/ clustering", "growth",
             "MiB merging", "cut median ms", "cut worst", "drawn");
  double before = 0;
  int sizeBefore = 0;
  for (const int size : sizes) {
    const auto footprints = std::make_shared<const FootprintTable>(
        footprintTable(synthesiseCity({CityPreset::Charlotte, size, 1})));
    const double trial = seconds([&] { (void)runPlainTrial(*footprints); });
    std::shared_ptr<const Dendrogram> dendrogram;
    const double clustering =
        seconds([&] { dendrogram = std::make_shared<const Dendrogram>(makeDendrogram(*footprints, {})); });
    resetPeak();
    const double resident = memory("VmRSS");
    ClusterTree tree;
    const double merging = seconds([&] { tree = makeClusterTree(footprints, dendrogram); });
    const double mebibytes = memory("VmHWM") - resident;
    const CutTimes cuts = cutTimes(tree);
    const double growth = before > 0 ? merging / before / (static_cast<double>(size) / sizeBefore) : 1;
    fmt::print(
        "{:>9} {:>8} {:>13.2f} {:>12.2f} {:>11.2f} {:>8.2f} {:>12.2f} {:>8.2f} {:>12.0f} {:>13.2f} {:>11.2f} "
        "{:>8.0f}\n",
        size, dendrogram->depth, trial, clustering, merging, merging / trial, merging / clustering, growth,
        mebibytes, cuts.median, cuts.worst, cuts.drawn);
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
