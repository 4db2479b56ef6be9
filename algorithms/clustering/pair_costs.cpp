#include "algorithms/clustering/pair_costs.h"

#include <cmath>

#include "algorithms/clustering/footprint_distance.h"

namespace lodestone {

PairCosts::PairCosts(const FootprintTable& footprints, const ClusterOptions& options,
                     const ClusterContext& context)
    : footprints_(footprints),
      options_(options),
      context_(context),
      attributes_(context.attributeWeight != 0 && !context.attribute.empty()) {
  if (!context.barriers.empty() && options.barrierFactor != 1) barriers_.emplace(context.barriers);
}

double PairCosts::difference(std::uint32_t a, std::uint32_t b) const {
  const double difference = std::abs(context_.attribute[a] - context_.attribute[b]);
  if (std::isnan(difference)) return 0;  // missing: equal to every neighbour
  return context_.attributeIsCategory ? (difference > 0 ? 1 : 0) : difference;
}

PairCost PairCosts::of(std::uint32_t a, std::uint32_t b, double distance) const {
  PairCost cost{distance, false};
  if (attributes_) cost.distance += context_.attributeWeight * difference(a, b);
  if (barriers_) {
    const ClosestPoints closest = closestPoints(footprints_, a, b, options_.distance);
    if (barriers_->crossedBy(closest.onFirst, closest.onSecond)) {
      cost.forbidden = options_.barrierFactor == 0;
      if (!cost.forbidden) cost.distance *= options_.barrierFactor;
    }
  }
  return cost;
}

}  // namespace lodestone
