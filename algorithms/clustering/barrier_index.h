// Lines that buildings are not to be joined across.
#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

/// A grid over the segments of many lines, for asking whether a straight segment crosses any of them.
///
/// A point on a line counts as lying to its left, so a segment that passes through a vertex of a line crosses
/// it once, and one that only touches it from the left, runs along it, or has no length does not.
/// Orientations are exact.
class BarrierIndex {
 public:
  explicit BarrierIndex(const std::vector<std::vector<Vec2>>& lines);

  /// The same for both directions. Cost: the cells that the segment passes, and what is in them.
  [[nodiscard]] bool crossedBy(const Vec2& from, const Vec2& to) const;

 private:
  struct Segment {
    Vec2 a, b;
  };
  template <class Visit>
  void forEachCell(const Segment& segment, Visit&& visit) const;
  [[nodiscard]] int column(double x) const;
  [[nodiscard]] int row(double y) const;

  std::vector<Segment> segments_;
  Box2 box_;
  double cell_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint32_t> cellStart_;
  std::vector<std::uint32_t> inCell_;
};

/// Whether the segment p–q crosses the segment a–b of a line, by the rule above.
[[nodiscard]] bool crossesBarrier(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b);

}  // namespace lodestone
