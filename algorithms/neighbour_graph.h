// Which buildings are looked at together (Chang et al. 2008, section 5).
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "algorithms/clustering.h"
#include "algorithms/packed_footprints.h"

namespace lodestone {

/// One end of an edge of the neighbour graph: the other end and the distance, in 12 bytes, since a county has
/// 25 million of them.
class Link {
 public:
  static constexpr std::uint32_t kMaxNodes = 1U << 31U;

  Link() = default;
  Link(std::uint32_t to, double distance, bool forbidden = false)
      : to_(to | (forbidden ? kMaxNodes : 0)),
        high_(static_cast<std::uint32_t>(bits(distance) >> 32U)),
        low_(static_cast<std::uint32_t>(bits(distance))) {}

  [[nodiscard]] std::uint32_t to() const { return to_ & ~kMaxNodes; }
  [[nodiscard]] double distance() const {
    return std::bit_cast<double>((static_cast<std::uint64_t>(high_) << 32U) | low_);
  }
  /// Crosses a barrier, and is used only when no other edge is left.
  [[nodiscard]] bool forbidden() const { return (to_ & kMaxNodes) != 0; }
  void retarget(std::uint32_t to) { to_ = to | (to_ & kMaxNodes); }

 private:
  static std::uint64_t bits(double distance) { return std::bit_cast<std::uint64_t>(distance); }

  std::uint32_t to_;
  std::uint32_t high_;
  std::uint32_t low_;
};

/// An undirected graph; each edge stands in the lists of both its ends. Lists are sorted: permitted before
/// forbidden, then by distance.
struct NeighbourGraph {
  std::vector<std::uint64_t> start{0};  ///< by node, and one past the last
  std::unique_ptr<Link[]> links;

  [[nodiscard]] std::uint32_t nodeCount() const { return static_cast<std::uint32_t>(start.size() - 1); }
  [[nodiscard]] std::span<Link> linksOf(std::uint32_t node) const {
    return {links.get() + start[node], links.get() + start[node + 1]};
  }
};

/// Permitted before forbidden, near before far.
void sortLinks(std::span<Link> links);

/// The k nearest buildings of each building, made symmetric, and the pairs that the minimum spanning tree of
/// all ground vertices joins: connected whatever k is. Nodes are slots of `packed`. Edges carry d, changed by
/// the context: the attribute term is added, then a pair whose closest segment crosses a barrier costs
/// barrierFactor times as much, or is forbidden where that is 0. Which pairs are neighbours depends on d
/// alone. Cost: O(n (k + log n)) time, about 36·k·n bytes while it works and a third less after. Incomplete
/// when a stop was requested.
[[nodiscard]] NeighbourGraph neighbourGraph(const PackedFootprints& packed, const FootprintTable& footprints,
                                            const ClusterOptions& options, const ClusterContext& context,
                                            const Progress& progress = {});

}  // namespace lodestone
