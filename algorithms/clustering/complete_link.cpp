#include <cmath>
#include <limits>
#include <stdexcept>

#include "algorithms/clustering/footprint_distance.h"
#include "algorithms/clustering/linkages.h"
#include "algorithms/clustering/pair_costs.h"
#include "algorithms/geometry/parallel.h"

namespace lodestone {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

/// Distances of all pairs of clusters; a forbidden pair's carries the sign bit.
class Distances {
 public:
  explicit Distances(std::uint32_t count) : values_(count < 2 ? 0 : std::size_t{count} * (count - 1) / 2) {}
  double& operator()(std::uint32_t a, std::uint32_t b) {
    if (a < b) std::swap(a, b);
    return values_[std::size_t{a} * (a - 1) / 2 + b];
  }

 private:
  std::vector<double> values_;
};

bool isForbidden(double value) {
  return std::signbit(value);
}

double further(double a, double b) {
  if (isForbidden(a) != isForbidden(b)) return isForbidden(a) ? a : b;
  return std::abs(a) > std::abs(b) ? a : b;
}

class CompleteLink {
 public:
  CompleteLink(Distances distances, const PackedFootprints& packed, const Progress& progress)
      : distances_(std::move(distances)),
        progress_(progress),
        leaf_(packed.building),
        size_(packed.count(), 1) {
    for (std::uint32_t i = 0; i < packed.count(); ++i) active_.push_back(i);
  }

  /// Follows nearest neighbours until two are each other's, joins them, and goes on where the chain stood.
  std::vector<Join> run() {
    std::vector<std::uint32_t> chain;
    while (active_.size() > 1 && !progress_.stopRequested()) {
      if (chain.empty()) chain.push_back(active_.front());
      const std::uint32_t last = chain.back();
      const std::uint32_t nearest = nearestOf(last);
      if (chain.size() > 1 && nearest == chain[chain.size() - 2]) {
        chain.resize(chain.size() - 2);
        unite(std::min(last, nearest), std::max(last, nearest));
        progress_.report(0.5 + 0.5 * static_cast<double>(joins_.size()) / static_cast<double>(leaf_.size()));
      } else {
        chain.push_back(nearest);
      }
    }
    return std::move(joins_);
  }

 private:
  [[nodiscard]] auto keyOf(std::uint32_t a, std::uint32_t b) {
    const double value = distances_(a, b);
    return std::tuple(isForbidden(value), std::abs(value), sizeProduct(size_[a], size_[b]),
                      std::min(leaf_[a], leaf_[b]), std::max(leaf_[a], leaf_[b]));
  }

  std::uint32_t nearestOf(std::uint32_t cluster) {
    std::uint32_t best = kNone;
    for (const std::uint32_t other : active_) {
      if (other == cluster) continue;
      if (best == kNone || keyOf(cluster, other) < keyOf(cluster, best)) best = other;
    }
    return best;
  }

  void unite(std::uint32_t kept, std::uint32_t dropped) {
    const double value = distances_(kept, dropped);
    Join join{std::abs(value), std::abs(value), leaf_[kept],       leaf_[dropped],
              size_[kept],     size_[dropped],  isForbidden(value)};
    if (join.low > join.high) {
      std::swap(join.low, join.high);
      std::swap(join.lowSize, join.highSize);
    }
    joins_.push_back(join);
    leaf_[kept] = join.low;
    size_[kept] = join.lowSize + join.highSize;
    std::erase(active_, dropped);
    for (const std::uint32_t other : active_) {
      if (other != kept)
        distances_(kept, other) = further(distances_(kept, other), distances_(dropped, other));
    }
  }

  Distances distances_;
  const Progress& progress_;
  std::vector<std::uint32_t> leaf_;
  std::vector<std::uint32_t> size_;
  std::vector<std::uint32_t> active_;
  std::vector<Join> joins_;
};

}  // namespace

std::vector<Join> completeLink(const PackedFootprints& packed, const FootprintTable& footprints,
                               const ClusterOptions& options, const ClusterContext& context,
                               const Progress& progress) {
  if (packed.count() > kCompleteLinkLimit) throw std::length_error("complete-link: too many buildings");
  const PairCosts costs(footprints, options, context);
  Distances distances(packed.count());
  const Progress silent({}, progress.stopToken());
  forPieces(1, packed.count(), 1, silent, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto a = static_cast<std::uint32_t>(i);
      for (std::uint32_t b = 0; b < a && !silent.stopRequested(); ++b) {
        const double d = std::sqrt(
            closestPoints(footprints, packed.building[a], packed.building[b], options.distance).squared);
        const PairCost cost = costs.of(packed.building[a], packed.building[b], d);
        distances(a, b) = std::copysign(cost.distance, cost.forbidden ? -1.0 : 1.0);
      }
    }
  });
  progress.report(0.5);
  std::vector<Join> joins = CompleteLink(std::move(distances), packed, progress).run();
  sortGreedily(joins);
  return joins;
}

}  // namespace lodestone
