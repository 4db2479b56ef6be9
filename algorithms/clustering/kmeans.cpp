#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

#include "algorithms/clustering/linkages.h"

namespace lodestone {
namespace {

constexpr int kMostIterations = 100;

/// A cluster that was divided, and what its two parts were.
struct Division {
  double squares = 0;   ///< sum of squared distances to the mean
  double distance = 0;  ///< of the parts' means
  std::uint32_t low = 0, high = 0, lowSize = 0, highSize = 0;
};

class Bisection {
 public:
  Bisection(const PackedFootprints& packed, const Progress& progress) : packed_(packed), progress_(progress) {
    for (const Box2& box : packed.box) centres_.push_back(box.center());
    order_.resize(packed.count());
    std::iota(order_.begin(), order_.end(), 0U);
  }

  std::vector<Division> run() {
    std::vector<std::span<std::uint32_t>> open{order_};
    while (!open.empty() && !progress_.stopRequested()) {
      const std::span<std::uint32_t> cluster = open.back();
      open.pop_back();
      if (cluster.size() < 2) continue;
      const std::size_t first = divide(cluster);
      record(cluster, first);
      open.push_back(cluster.first(first));
      open.push_back(cluster.subspan(first));
      progress_.report(static_cast<double>(divisions_.size()) / static_cast<double>(order_.size()));
    }
    return std::move(divisions_);
  }

 private:
  using Members = std::span<const std::uint32_t>;

  [[nodiscard]] Vec2 meanOf(Members members) const {
    Vec2 sum = Vec2::Zero();
    for (const std::uint32_t m : members) sum += centres_[m];
    return sum / static_cast<double>(members.size());
  }

  [[nodiscard]] std::uint32_t furthestFrom(const Vec2& point, Members members) const {
    return *std::max_element(members.begin(), members.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tuple((centres_[a] - point).squaredNorm(), packed_.building[b]) <
             std::tuple((centres_[b] - point).squaredNorm(), packed_.building[a]);
    });
  }

  /// Sorts the members into two parts and returns the size of the first. Neither is empty.
  std::size_t divide(std::span<std::uint32_t> members) {
    const std::uint32_t one = furthestFrom(meanOf(members), members);
    Vec2 a = centres_[one];
    Vec2 b = centres_[furthestFrom(a, members)];
    std::size_t first = members.size() / 2;  // where all stand at one point, any half will do
    for (int i = 0; i < kMostIterations && a != b && !progress_.stopRequested(); ++i) {
      const auto middle = std::stable_partition(members.begin(), members.end(), [&](std::uint32_t m) {
        return (centres_[m] - a).squaredNorm() <= (centres_[m] - b).squaredNorm();
      });
      const auto size = static_cast<std::size_t>(middle - members.begin());
      if (size == 0 || size == members.size()) break;
      const Vec2 nextA = meanOf(members.first(size));
      const Vec2 nextB = meanOf(members.subspan(size));
      first = size;
      if (nextA == a && nextB == b) break;
      a = nextA;
      b = nextB;
    }
    return first;
  }

  void record(Members cluster, std::size_t first) {
    Division division;
    const Vec2 mean = meanOf(cluster);
    for (const std::uint32_t m : cluster) division.squares += (centres_[m] - mean).squaredNorm();
    division.distance = (meanOf(cluster.first(first)) - meanOf(cluster.subspan(first))).norm();
    division.low = smallestLeaf(cluster.first(first));
    division.high = smallestLeaf(cluster.subspan(first));
    division.lowSize = static_cast<std::uint32_t>(first);
    division.highSize = static_cast<std::uint32_t>(cluster.size() - first);
    if (division.low > division.high) {
      std::swap(division.low, division.high);
      std::swap(division.lowSize, division.highSize);
    }
    divisions_.push_back(division);
  }

  [[nodiscard]] std::uint32_t smallestLeaf(Members members) const {
    std::uint32_t least = packed_.building[members.front()];
    for (const std::uint32_t m : members) least = std::min(least, packed_.building[m]);
    return least;
  }

  const PackedFootprints& packed_;
  const Progress& progress_;
  std::vector<Vec2> centres_;
  std::vector<std::uint32_t> order_;
  std::vector<Division> divisions_;
};

}  // namespace

std::vector<Join> bisectingKMeans(const PackedFootprints& packed, const Progress& progress) {
  std::vector<Join> joins;
  for (const Division& d : Bisection(packed, progress).run()) {
    joins.push_back({d.distance, d.squares, d.low, d.high, d.lowSize, d.highSize, false});
  }
  const auto bySize = [](const Join& join) {
    return std::tuple(join.lowSize + join.highSize, join.low, join.high);
  };
  std::sort(joins.begin(), joins.end(), [&](const Join& a, const Join& b) { return bySize(a) < bySize(b); });
  // A part's sum of squares is never above the whole's; rounding must not make it so.
  std::map<std::uint32_t, double> squaresOf;  // by smallest leaf: of the largest cluster so far
  for (Join& join : joins) {
    join.weight = std::max({join.weight, squaresOf[join.low], squaresOf[join.high]});
    squaresOf[join.low] = join.weight;
  }
  std::stable_sort(joins.begin(), joins.end(),
                   [](const Join& a, const Join& b) { return a.weight < b.weight; });
  return joins;
}

}  // namespace lodestone
