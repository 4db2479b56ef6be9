#include "plain_trial.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include <tbb/parallel_for.h>

namespace lodestone {
namespace {

constexpr int kNeighbours = 50;

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

}  // namespace

int runPlainTrial(const FootprintTable& table) {
  PlainTrial trial(table);
  trial.run();
  return trial.depth();
}

}  // namespace lodestone
