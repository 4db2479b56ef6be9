#include "algorithms/switching/building_levels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/exterior.h"

namespace lodestone {
namespace {

/// Side of the square that each building would have to itself.
double meanSpacing(const std::vector<Box3>& boxes) {
  Box2 all;
  double count = 0;
  for (const Box3& box : boxes) {
    if (box.empty()) continue;
    all.add(Vec2(box.center().head<2>()));
    ++count;
  }
  if (count < 2) return 0;
  // The outermost stand on the border: half of their squares would lie outside.
  const double inner = std::max(1.0, std::sqrt(count) - 1);
  return std::sqrt(all.size().x() * all.size().y()) / inner;
}

}  // namespace

double cutOff(double alpha, double beta, double gamma, double x) {
  return alpha * beta * std::pow(gamma, x);
}

BuildingLevels::BuildingLevels(std::shared_ptr<const CityModel> city, const CutOffOptions& options)
    : city_(std::move(city)) {
  for (const Building& building : city_->buildings) boxes_.push_back(bounds(building));
  constexpr double kLeast = 1;  // metre: below it Y would fall with x
  plotRadius_ = std::max(kLeast, options.plotRadius > 0 ? options.plotRadius : meanSpacing(boxes_) / 2);
  for (std::size_t b = 0; b < boxes_.size(); ++b) {
    const Building& building = city_->buildings[b];
    std::vector<double> ranks = exteriorRanks(building.object);
    std::reverse(ranks.begin(), ranks.end());
    for (const double rank : ranks) faces_.push_back(facesOf(building, rank));
    if (ranks.empty()) faces_.push_back(facesOf(building));
    const double alpha = boxes_[b].empty() ? 0 : boxes_[b].size().norm();
    for (std::size_t i = 1; i < ranks.size(); ++i)
      distances_.push_back(cutOff(alpha, options.beta, plotRadius_,
                                  static_cast<double>(i) / static_cast<double>(ranks.size() - 1)));
    first_.push_back(static_cast<std::uint32_t>(faces_.size()));
  }
}

}  // namespace lodestone
