#include "algorithms/clustering/nearest_buildings.h"

#include <algorithm>
#include <array>

#include <tbb/enumerable_thread_specific.h>

#include "algorithms/clustering/box_tree.h"
#include "algorithms/geometry/parallel.h"
#include "algorithms/geometry/vector_clones.h"

namespace lodestone {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kBlock = BoxTree::kFan;  // buildings that are looked for, and looked at, together

/// Squared distances from each of n points to the nearest of m others. Written for the vectoriser: the
/// minimum is exact in any order, so every instruction set gives the same bits.
LODESTONE_VECTOR_CLONES
void nearestSquares(const double* x, const double* y, std::size_t n, const double* ox, const double* oy,
                    std::size_t m, double* squared) {
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = x[i] - ox[0];
    const double dy = y[i] - oy[0];
    squared[i] = dx * dx + dy * dy;
  }
  for (std::size_t j = 1; j < m; j += 2) {
    const std::size_t next = j + 1 < m ? j + 1 : j;
    const double x0 = ox[j];
    const double y0 = oy[j];
    const double x1 = ox[next];
    const double y1 = oy[next];
    for (std::size_t i = 0; i < n; ++i) {
      const double dx0 = x[i] - x0;
      const double dy0 = y[i] - y0;
      const double dx1 = x[i] - x1;
      const double dy1 = y[i] - y1;
      const double s0 = dx0 * dx0 + dy0 * dy0;
      const double s1 = dx1 * dx1 + dy1 * dy1;
      const double s = s0 < s1 ? s0 : s1;
      squared[i] = s < squared[i] ? s : squared[i];
    }
  }
}

struct Found {
  double squared;
  std::uint32_t building;
  std::uint32_t slot;
  bool operator<(const Found& other) const {
    return squared != other.squared ? squared < other.squared : building < other.building;
  }
};

/// The k smallest of what it is offered. Keeps up to 2k, and halves them in linear time.
class Smallest {
 public:
  void reset(std::uint32_t k) {
    k_ = k;
    bound_ = kInfinity;
    found_.clear();
  }
  [[nodiscard]] double bound() const { return bound_; }
  void offer(double squared, std::uint32_t building, std::uint32_t slot) {
    if (squared > bound_) return;
    found_.push_back({squared, building, slot});
    if (found_.size() >= 2 * static_cast<std::size_t>(k_)) shrink();
  }
  void shrink() {
    if (found_.size() < k_) return;
    std::nth_element(found_.begin(), found_.begin() + (k_ - 1), found_.end());
    found_.resize(k_);
    bound_ = found_.back().squared;
  }
  const std::vector<Found>& sorted() {
    shrink();
    std::sort(found_.begin(), found_.end());
    return found_;
  }

 private:
  std::uint32_t k_ = 0;
  double bound_ = kInfinity;
  std::vector<Found> found_;
};

/// Searches for the buildings of one block after the other; one a thread.
class Searcher {
 public:
  Searcher(const PackedFootprints& packed, const FootprintTable& table, FootprintDistance distance,
           std::uint32_t perSlot, const BoxTree& tree, NearestBuildings& result)
      : packed_(packed),
        table_(table),
        distance_(distance),
        perSlot_(perSlot),
        tree_(tree),
        result_(result) {}

  void search(std::uint32_t block) {
    first_ = block * kBlock;
    last_ = std::min(first_ + kBlock, packed_.count());
    for (std::uint32_t q = first_; q < last_; ++q) smallest_[q - first_].reset(perSlot_);
    // Neighbours along the curve give a first bound, so that the tree is asked for near blocks alone.
    const std::uint32_t reach = perSlot_ / kBlock / 2 + 2;
    const std::uint32_t from = block - std::min(block, reach);
    const std::uint32_t to = std::min(block + reach + 1, tree_.blockCount());
    for (std::uint32_t other = from; other < to; ++other) look(other);
    double bound = 0;
    for (std::uint32_t q = first_; q < last_; ++q) {
      smallest_[q - first_].shrink();
      bound = std::max(bound, smallest_[q - first_].bound());
    }
    tree_.within(tree_.blockBox(block), bound, near_);
    std::sort(near_.begin(), near_.end());
    for (const auto& [squared, other] : near_) {
      if (other < from || other >= to) look(other);
    }
    store();
  }

 private:
  /// Offers the buildings of a block to every query that it may matter to.
  void look(std::uint32_t block) {
    const Box2& box = tree_.blockBox(block);
    for (std::uint32_t q = first_; q < last_; ++q) {
      if (squaredDistance(packed_.box[q], box) > smallest_[q - first_].bound()) continue;
      if (distance_ == FootprintDistance::Vertex) {
        offerByVertices(q, block);
      } else {
        offerByOutlines(q, block);
      }
    }
  }

  void offerByVertices(std::uint32_t q, std::uint32_t block) {
    const std::uint32_t begin = block * kBlock;
    const std::uint32_t end = std::min(begin + kBlock, packed_.count());
    const std::uint32_t v0 = packed_.vertexStart[begin];
    const std::uint32_t n = packed_.vertexStart[end] - v0;
    const std::uint32_t q0 = packed_.vertexStart[q];
    if (squares_.size() < n) squares_.resize(n);
    nearestSquares(&packed_.x[v0], &packed_.y[v0], n, &packed_.x[q0], &packed_.y[q0],
                   packed_.vertexStart[q + 1] - q0, squares_.data());
    Smallest& smallest = smallest_[q - first_];
    const double* square = squares_.data();
    for (std::uint32_t slot = begin; slot < end; ++slot) {
      double least = kInfinity;
      const double* stop = squares_.data() + (packed_.vertexStart[slot + 1] - v0);
      for (; square < stop; ++square) least = std::min(least, *square);
      if (slot != q) smallest.offer(least, packed_.building[slot], slot);
    }
  }

  void offerByOutlines(std::uint32_t q, std::uint32_t block) {
    Smallest& smallest = smallest_[q - first_];
    const std::uint32_t end = std::min((block + 1) * kBlock, packed_.count());
    for (std::uint32_t slot = block * kBlock; slot < end; ++slot) {
      if (slot == q || squaredDistance(packed_.box[q], packed_.box[slot]) > smallest.bound()) continue;
      const std::uint32_t building = packed_.building[slot];
      const ClosestPoints closest =
          closestPoints(table_, packed_.building[q], building, distance_, smallest.bound());
      smallest.offer(closest.squared, building, slot);
    }
  }

  void store() {
    for (std::uint32_t q = first_; q < last_; ++q) {
      const std::vector<Found>& found = smallest_[q - first_].sorted();
      LinkList list(found.size());
      for (std::size_t i = 0; i < found.size(); ++i) list.span()[i] = Link(found[i].slot, found[i].squared);
      result_.lists[q] = std::move(list);
      result_.farthest[q] = {found.back().squared, found.back().building};
    }
  }

  const PackedFootprints& packed_;
  const FootprintTable& table_;
  FootprintDistance distance_;
  std::uint32_t perSlot_;
  const BoxTree& tree_;
  NearestBuildings& result_;
  std::uint32_t first_ = 0;
  std::uint32_t last_ = 0;
  std::array<Smallest, kBlock> smallest_;
  std::vector<double> squares_;
  std::vector<BoxTree::Hit> near_;
};

}  // namespace

NearestBuildings nearestBuildings(const PackedFootprints& packed, const FootprintTable& table,
                                  FootprintDistance distance, std::uint32_t k, const Progress& progress) {
  NearestBuildings result;
  const std::uint32_t n = packed.count();
  const std::uint32_t perSlot = n == 0 ? 0 : std::min(k, n - 1);
  result.lists.resize(n);
  result.farthest.resize(n);
  if (perSlot == 0) return result;
  const BoxTree tree(packed.box);
  tbb::enumerable_thread_specific<Searcher> searchers(
      [&] { return Searcher(packed, table, distance, perSlot, tree, result); });
  forPiecesReported(tree.blockCount(), 16, progress, [&](std::size_t first, std::size_t last) {
    Searcher& searcher = searchers.local();
    for (std::size_t block = first; block < last && !progress.stopRequested(); ++block) {
      searcher.search(static_cast<std::uint32_t>(block));
    }
  });
  return result;
}

}  // namespace lodestone
