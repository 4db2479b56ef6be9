#include "algorithms/geometry/overlap_area.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/geometry/close_segments.h"

namespace lodestone {
namespace {

double heightAt(const OverlapSide& side, double x) {
  const double t = (x - side.from.x()) / (side.to.x() - side.from.x());
  return side.from.y() + t * (side.to.y() - side.from.y());
}

/// x where two sides cross, if they do.
void addCrossing(const OverlapSide& a, const OverlapSide& b, std::vector<double>& cuts) {
  const Vec2 u = a.to - a.from;
  const Vec2 v = b.to - b.from;
  const double across = u.x() * v.y() - u.y() * v.x();
  if (across == 0) return;
  const Vec2 w = b.from - a.from;
  const double t = (w.x() * v.y() - w.y() * v.x()) / across;
  const double s = (w.x() * u.y() - w.y() * u.x()) / across;
  if (t > 0 && t < 1 && s > 0 && s < 1) cuts.push_back(a.from.x() + t * u.x());
}

/// Area that both sets cover in the strip, where no sides cross.
double stripArea(const std::vector<OverlapSide>& sides, double left, double right,
                 std::vector<std::pair<double, const OverlapSide*>>& standing) {
  const double middle = (left + right) / 2;
  standing.clear();
  for (const OverlapSide& side : sides) {
    if ((side.from.x() < middle) != (side.to.x() < middle))
      standing.emplace_back(heightAt(side, middle), &side);
  }
  std::sort(standing.begin(), standing.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  double length = 0;
  std::array<int, 2> winding{};
  for (std::size_t i = 0; i < standing.size(); ++i) {
    const auto& [height, side] = standing[i];
    if (winding[0] > 0 && winding[1] > 0) length += height - standing[i - 1].first;
    winding[side->set] +=
        side->to.x() > side->from.x() ? 1 : -1;  // upwards through it: into or out of its footprint
  }
  return length * (right - left);
}

/// The part of the x axis that both sets reach.
std::pair<double, double> commonRange(const std::vector<OverlapSide>& sides) {
  std::array<Box2, 2> box;
  for (const OverlapSide& side : sides) {
    box[side.set].add(side.from);
    box[side.set].add(side.to);
  }
  return {std::max(box[0].min.x(), box[1].min.x()), std::min(box[0].max.x(), box[1].max.x())};
}

}  // namespace

double overlapArea(const std::vector<OverlapSide>& sides) {
  const auto [left, right] = commonRange(sides);
  if (!(left < right)) return 0;
  std::vector<double> cuts{left, right};
  for (const OverlapSide& side : sides) cuts.push_back(side.from.x());
  const auto segment = [&](std::size_t i) { return std::pair(sides[i].from, sides[i].to); };
  forCloseSegments(sides.size(), segment, [&](std::size_t i, std::size_t j) {
    addCrossing(sides[i], sides[j], cuts);
    return true;
  });
  std::sort(cuts.begin(), cuts.end());
  std::vector<std::pair<double, const OverlapSide*>> standing;
  double sum = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (cuts[i - 1] >= left && cuts[i] <= right && cuts[i - 1] < cuts[i]) {
      sum += stripArea(sides, cuts[i - 1], cuts[i], standing);
    }
  }
  return sum;
}

}  // namespace lodestone
