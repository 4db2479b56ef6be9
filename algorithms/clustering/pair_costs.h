// What a pair of buildings costs beyond its distance: attributes that differ, and barriers between.
#pragma once

#include <optional>

#include "algorithms/clustering/barrier_index.h"
#include "algorithms/clustering/neighbour_graph.h"

namespace lodestone {

/// Distance of a pair as clustering sees it.
struct PairCost {
  double distance = 0;     ///< metres
  bool forbidden = false;  ///< crosses a barrier, and barriers are absolute
};

/// Attribute term and barriers of methods.md 1.2: (d + weight · |difference|) · factor.
class PairCosts {
 public:
  PairCosts(const FootprintTable& footprints, const ClusterOptions& options, const ClusterContext& context);

  /// Whether any pair can cost more than its distance.
  [[nodiscard]] bool any() const { return attributes_ || barriers_.has_value(); }
  /// Cost of buildings a and b, `distance` metres apart.
  [[nodiscard]] PairCost of(std::uint32_t a, std::uint32_t b, double distance) const;

 private:
  [[nodiscard]] double difference(std::uint32_t a, std::uint32_t b) const;

  const FootprintTable& footprints_;
  const ClusterOptions& options_;
  const ClusterContext& context_;
  bool attributes_ = false;
  std::optional<BarrierIndex> barriers_;
};

}  // namespace lodestone
