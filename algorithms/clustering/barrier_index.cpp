#include "algorithms/clustering/barrier_index.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/predicates.h"

namespace lodestone {
namespace {

constexpr double kPad =
    1e-6;  // of a cell: more than rounding, where a segment runs along the border of two rows

bool isLeft(const Vec2& a, const Vec2& b, const Vec2& p) {
  return orientation(a, b, p) >= 0;
}

}  // namespace

bool crossesBarrier(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b) {
  if (p == q || isLeft(a, b, p) == isLeft(a, b, q)) return false;
  // One direction for both ways of asking: a line's vertex on p–q must not change sides with it.
  return lexicographicallyLess(p, q) ? isLeft(p, q, a) != isLeft(p, q, b)
                                     : isLeft(q, p, a) != isLeft(q, p, b);
}

BarrierIndex::BarrierIndex(const std::vector<std::vector<Vec2>>& lines) {
  for (const std::vector<Vec2>& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (line[i - 1] == line[i]) continue;
      segments_.push_back({line[i - 1], line[i]});
      box_.add(line[i - 1]);
      box_.add(line[i]);
    }
  }
  if (segments_.empty()) return;
  // About one segment a cell, whatever the proportions of the whole.
  const auto count = static_cast<double>(segments_.size());
  const Vec2 size = box_.size();
  cell_ =
      std::max({std::sqrt(size.x() * size.y() / count), size.maxCoeff() / (4 * std::sqrt(count) + 4), 1e-3});
  columns_ = static_cast<int>(size.x() / cell_) + 1;
  rows_ = static_cast<int>(size.y() / cell_) + 1;
  cellStart_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Segment& s : segments_) {
    forEachCell(s, [&](std::size_t cell) {
      ++cellStart_[cell + 1];
      return false;
    });
  }
  for (std::size_t i = 1; i < cellStart_.size(); ++i) cellStart_[i] += cellStart_[i - 1];
  inCell_.resize(cellStart_.back());
  std::vector<std::uint32_t> next(cellStart_.begin(), cellStart_.end() - 1);
  for (std::uint32_t s = 0; s < segments_.size(); ++s) {
    forEachCell(segments_[s], [&](std::size_t cell) {
      inCell_[next[cell]++] = s;
      return false;
    });
  }
}

int BarrierIndex::column(double x) const {
  return static_cast<int>(std::clamp((x - box_.min.x()) / cell_, 0.0, columns_ - 1.0));
}

int BarrierIndex::row(double y) const {
  return static_cast<int>(std::clamp((y - box_.min.y()) / cell_, 0.0, rows_ - 1.0));
}

/// Row by row, the cells between the segment's two crossings of the row, and one more to each side for
/// rounding. Stops when `visit` returns true.
template <class Visit>
void BarrierIndex::forEachCell(const Segment& segment, Visit&& visit) const {
  const Vec2& low = segment.a.y() <= segment.b.y() ? segment.a : segment.b;
  const Vec2& high = segment.a.y() <= segment.b.y() ? segment.b : segment.a;
  const double slope = high.y() > low.y() ? (high.x() - low.x()) / (high.y() - low.y()) : 0;
  const auto xAt = [&](double y) {
    if (y <= low.y()) return low.x();
    return y >= high.y() ? high.x() : low.x() + (y - low.y()) * slope;
  };
  const int lastRow = row(high.y());
  for (int r = row(low.y()); r <= lastRow; ++r) {
    const double bottom = box_.min.y() + r * cell_;
    const bool flat = high.y() == low.y();
    const double x0 = flat ? low.x() : xAt(bottom - kPad * cell_);
    const double x1 = flat ? high.x() : xAt(bottom + (1 + kPad) * cell_);
    const int first = std::max(column(std::min(x0, x1)) - 1, 0);
    const int last = std::min(column(std::max(x0, x1)) + 1, columns_ - 1);
    for (int c = first; c <= last; ++c) {
      if (visit(static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(c)))
        return;
    }
  }
}

bool BarrierIndex::crossedBy(const Vec2& from, const Vec2& to) const {
  if (segments_.empty() || from == to) return false;
  Box2 box;
  box.add(from);
  box.add(to);
  if ((box.min.array() > box_.max.array()).any() || (box.max.array() < box_.min.array()).any()) return false;
  bool crossed = false;
  forEachCell({from, to}, [&](std::size_t cell) {
    for (std::uint32_t i = cellStart_[cell]; i < cellStart_[cell + 1] && !crossed; ++i) {
      const Segment& s = segments_[inCell_[i]];
      crossed = crossesBarrier(from, to, s.a, s.b);
    }
    return crossed;
  });
  return crossed;
}

}  // namespace lodestone
