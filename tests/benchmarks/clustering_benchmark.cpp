// Clustering against a plain trial of the same idea, on a made-up city with the counts of table 1 in Chang et
// al. 2008.
//
// usage: clustering_benchmark [--growth MOST_BUILDINGS] [--floor PROGRAM]
//
// The plain trial is what one writes in an afternoon: a uniform grid searched ring by ring, a vector of
// neighbours for each building, rounds of joining mutual choices with sorted vectors; no spanning tree,
// single precision, no ties, no progress. PROGRAM is an external trial that takes the number of buildings and
// is timed beside it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <queue>
#include <string>

#include <tbb/parallel_for.h>

#include "algorithms/clustering.h"
#include "algorithms/synthesis.h"

namespace lodestone {
namespace {

constexpr int kNeighbours = 50;

double seconds(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Time of all threads together: what remains comparable on a machine that others use too.
double processorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Resident memory from /proc, in MiB: "VmRSS" now, "VmHWM" at most since resetPeak().
double memory(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(field + ":")) return std::stod(line.substr(field.size() + 1)) / 1024;
  }
  return 0;
}

void resetPeak() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

/// The plain trial.
class PlainTrial {
 public:
  explicit PlainTrial(const FootprintTable& table)
      : table_(table), count_(static_cast<int>(table.buildingCount())) {}

  void run() {
    makeGrid();
    makeGraph();
    join();
  }
  [[nodiscard]] int depth() const { return depth_; }

 private:
  using Near = std::pair<float, int>;
  using Edge = std::pair<int, float>;
  static constexpr float kCell = 40;

  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> vertices(int b) const {
    return {table_.ringStart[table_.buildingRing[static_cast<std::size_t>(b)]],
            table_.ringStart[table_.buildingRing[static_cast<std::size_t>(b) + 1]]};
  }
  [[nodiscard]] int column(double x) const { return static_cast<int>((x - all_.min.x()) / kCell); }
  [[nodiscard]] int row(double y) const { return static_cast<int>((y - all_.min.y()) / kCell); }
  [[nodiscard]] std::vector<int>& cell(int x, int y) {
    return grid_[static_cast<std::size_t>(y) * columns_ + x];
  }

  void makeGrid() {
    for (int b = 0; b < count_; ++b) {
      Box2 box;
      for (auto [v, end] = vertices(b); v < end; ++v) box.add(table_.vertices[v]);
      boxes_.push_back(box);
      all_.add(box);
      radius_ = std::max(radius_, static_cast<float>(box.size().maxCoeff() / 2));
    }
    columns_ = column(all_.max.x()) + 1;
    rows_ = row(all_.max.y()) + 1;
    grid_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (int b = 0; b < count_; ++b)
      cell(column(boxes_[b].center().x()), row(boxes_[b].center().y())).push_back(b);
  }

  [[nodiscard]] float squared(int a, int b) const {
    float best = 1e30F;
    const auto [a0, a1] = vertices(a);
    const auto [b0, b1] = vertices(b);
    for (std::uint32_t i = a0; i < a1; ++i) {
      for (std::uint32_t j = b0; j < b1; ++j) {
        best = std::min(best, static_cast<float>((table_.vertices[i] - table_.vertices[j]).squaredNorm()));
      }
    }
    return best;
  }

  [[nodiscard]] float boxSquared(int a, int b) const {
    const Vec2 gap = (boxes_[a].min - boxes_[b].max).cwiseMax(boxes_[b].min - boxes_[a].max).cwiseMax(0.0);
    return static_cast<float>(gap.squaredNorm());
  }

  void search(int b, std::vector<Near>& nearest) {
    std::priority_queue<Near> queue;
    const int cx = column(boxes_[b].center().x());
    const int cy = row(boxes_[b].center().y());
    for (int ring = 0; ring <= columns_ + rows_; ++ring) {
      const float reach = static_cast<float>(ring - 1) * kCell - 2 * radius_;
      if (queue.size() == kNeighbours && reach > 0 && reach * reach > queue.top().first) break;
      for (int y = std::max(cy - ring, 0); y <= std::min(cy + ring, rows_ - 1); ++y) {
        const int step = std::abs(y - cy) == ring ? 1 : std::max(1, 2 * ring);
        for (int x = cx - ring; x <= cx + ring; x += step) {
          if (x < 0 || x >= columns_) continue;
          for (const int other : cell(x, y)) {
            const bool full = queue.size() == kNeighbours;
            if (other == b || (full && boxSquared(b, other) >= queue.top().first)) continue;
            const float d = squared(b, other);
            if (full && d >= queue.top().first) continue;
            if (full) queue.pop();
            queue.emplace(d, other);
          }
        }
      }
    }
    for (; !queue.empty(); queue.pop())
      nearest.emplace_back(std::sqrt(queue.top().first), queue.top().second);
  }

  static void tidy(std::vector<Edge>& edges) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end(),
                            [](const Edge& a, const Edge& b) { return a.first == b.first; }),
                edges.end());
  }

  void makeGraph() {
    std::vector<std::vector<Near>> nearest(static_cast<std::size_t>(count_));
    tbb::parallel_for(0, count_, [&](int b) { search(b, nearest[b]); });
    edges_.resize(nearest.size());
    for (int b = 0; b < count_; ++b) {
      for (const auto& [d, other] : nearest[b]) {
        edges_[b].emplace_back(other, d);
        edges_[other].emplace_back(b, d);
      }
    }
    for (auto& edges : edges_) tidy(edges);
  }

  void choose(int b) {
    double least = 1e300;
    choice_[b] = -1;
    for (const auto& [other, d] : edges_[b]) {
      const double weight = static_cast<double>(size_[b]) * size_[other] * d;
      if (weight < least) {
        least = weight;
        choice_[b] = other;
      }
    }
  }

  void join() {
    const auto n = static_cast<std::size_t>(count_);
    size_.assign(n, 1);
    choice_.assign(n, -1);
    std::vector<int> levels(n, 0);
    std::vector<int> into(n);
    std::vector<int> active(n);
    for (int b = 0; b < count_; ++b) into[b] = active[b] = b;
    for (const int b : active) choose(b);
    for (bool joined = true; joined;) {
      std::vector<std::pair<int, int>> pairs;
      for (const int b : active) {
        if (choice_[b] > b && choice_[choice_[b]] == b) pairs.emplace_back(b, choice_[b]);
      }
      joined = !pairs.empty();
      for (const auto& [a, b] : pairs) into[b] = a;
      std::vector<int> touched;
      for (const auto& [a, b] : pairs) {
        edges_[a].insert(edges_[a].end(), edges_[b].begin(), edges_[b].end());
        std::vector<Edge>().swap(edges_[b]);
        size_[a] += size_[b];
        levels[a] = std::max(levels[a], levels[b]) + 1;
        depth_ = std::max(depth_, levels[a]);
        touched.push_back(a);
        for (auto& edge : edges_[a]) touched.push_back(edge.first = into[edge.first]);
      }
      std::sort(touched.begin(), touched.end());
      touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
      for (const int b : touched) {
        for (auto& edge : edges_[b]) edge.first = into[edge.first];
        std::erase_if(edges_[b], [b](const Edge& edge) { return edge.first == b; });
        tidy(edges_[b]);
      }
      for (const int b : touched) choose(b);
      std::erase_if(active, [&](int b) { return into[b] != b; });
    }
  }

  const FootprintTable& table_;
  int count_;
  Box2 all_;
  std::vector<Box2> boxes_;
  float radius_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::vector<int>> grid_;
  std::vector<std::vector<Edge>> edges_;
  std::vector<int> size_;
  std::vector<int> choice_;
  int depth_ = 0;
};

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
  PlainTrial trial(table);
  const double processor = processorSeconds();
  const double plain = seconds([&] { trial.run(); });
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

void grow(int most) {
  std::printf("\ngrowth: buildings x 4 -> time x at most 4.8\n");
  double before = 0;
  for (int n = 92482; n <= most; n *= 4) {
    const Run run = cluster(city(CityPreset::Charlotte, n), Linkage::Legible);
    std::printf("%9d buildings %8.2f s", n, run.time);
    if (before > 0) std::printf("  x %.2f", run.time / before);
    std::printf("  %6.0f MiB\n", run.mebibytes);
    std::fflush(stdout);
    before = run.time;
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
