#include "algorithms/merging/merged_hull.h"

#include <algorithm>

#include "algorithms/geometry/predicates.h"

namespace lodestone {
namespace {

bool laterDivision(const Division& x, const Division& y) {
  return y.comesBefore(x);
}

}  // namespace

std::span<const Vec2> MergedHull::make(std::span<const std::span<const Vec2>> rings, std::size_t targetEdges,
                                       bool simple) {
  rings_.assign(rings);
  search_.begin(simple);
  result_.clear();
  if (!startFromConvexHull()) return {};
  divideUntil(targetEdges);
  collect();
  return result_;
}

/// Andrew's monotone chain, keeping vertices on straight sides. False when there is no area.
bool MergedHull::startFromConvexHull() {
  const VertexId count = rings_.vertexCount();
  convex_.clear();
  if (count < 3) return false;
  const auto extend = [&](VertexId v, std::size_t keep) {
    while (convex_.size() >= keep + 2 && orientation(rings_.point(convex_[convex_.size() - 2]),
                                                     rings_.point(convex_.back()), rings_.point(v)) < 0) {
      convex_.pop_back();
    }
    convex_.push_back(v);
  };
  for (VertexId v = 0; v < count; ++v) extend(v, 0);
  const std::size_t lower = convex_.size();
  for (VertexId v = count - 1; v-- > 1;) extend(v, lower - 1);
  extend(0, lower - 1);
  if (convex_.size() + 1 == 2 * std::size_t{count}) return false;  // all are on both chains: collinear
  convex_.pop_back();
  hull_.next.assign(count, kNoVertex);
  hull_.bridges.clear();
  previous_.assign(count, kNoVertex);
  for (std::size_t i = 0; i < convex_.size(); ++i) {
    const VertexId next = convex_[(i + 1) % convex_.size()];
    hull_.next[convex_[i]] = next;
    previous_[next] = convex_[i];
  }
  start_ = 0;
  edges_ = 0;
  for (const VertexId v : convex_) edges_ += isCorner(previous_[v], v, hull_.next[v]) ? 1 : 0;
  return true;
}

bool MergedHull::isCorner(VertexId before, VertexId v, VertexId after) const {
  return orientation(rings_.point(before), rings_.point(v), rings_.point(after)) != 0;
}

void MergedHull::push(const Division& division) {
  candidates_.push_back(division);
  std::push_heap(candidates_.begin(), candidates_.end(), laterDivision);
}

/// Looks for the best division of the edge that starts at a.
void MergedHull::consider(VertexId a) {
  if (const std::optional<Division> division = search_.largest(a, hull_.next[a])) push(*division);
}

void MergedHull::divideUntil(std::size_t target) {
  candidates_.clear();
  passedOver_.clear();
  if (edges_ >= target) return;
  for (const VertexId v : convex_) {
    if (search_.isBridge(v, hull_.next[v])) hull_.bridges.push_back(v);
  }
  for (const VertexId v : convex_) consider(v);
  while (edges_ < target && !candidates_.empty()) {
    std::pop_heap(candidates_.begin(), candidates_.end(), laterDivision);
    const Division division = candidates_.back();
    candidates_.pop_back();
    if (!search_.isOpen(division)) {
      consider(division.a);
    } else if (static_cast<int>(edges_) + edgesAdded(division) > static_cast<int>(target)) {
      passedOver_.push_back(division);  // may fit when a neighbour has been divided
    } else {
      divide(division);
      for (const Division& other : passedOver_) push(other);
      passedOver_.clear();
    }
  }
}

/// Edges more after a division: one for p, and for each end that was or becomes the middle of a straight
/// side.
int MergedHull::edgesAdded(const Division& division) const {
  const auto [area, p, a, b] = division;
  const VertexId before = previous_[a];
  const VertexId after = hull_.next[b];
  return 1 + isCorner(before, a, p) - isCorner(before, a, b) + isCorner(p, b, after) - isCorner(a, b, after);
}

void MergedHull::divide(const Division& division) {
  const auto [area, p, a, b] = division;
  edges_ = static_cast<std::size_t>(static_cast<int>(edges_) + edgesAdded(division));
  std::erase(hull_.bridges, a);
  std::vector<VertexId> onSides = search_.onSides();
  std::sort(onSides.begin(), onSides.end());
  onSides.erase(std::unique(onSides.begin(), onSides.end()), onSides.end());
  const Vec2& apex = rings_.point(p);
  const auto onFirst = [&](VertexId v) { return orientation(rings_.point(a), apex, rings_.point(v)) == 0; };
  const auto split = std::partition(onSides.begin(), onSides.end(), onFirst);
  std::vector<VertexId> first(onSides.begin(), split);
  std::vector<VertexId> second(split, onSides.end());
  link(a, p, first);
  link(p, b, second);
  for (VertexId v = a; v != b; v = hull_.next[v]) {
    if (search_.isBridge(v, hull_.next[v])) hull_.bridges.push_back(v);
  }
  for (VertexId v = a; v != b; v = hull_.next[v]) consider(v);
}

/// Joins two vertices by way of those on the segment between them. Vertex numbers rise by x, then y, so along
/// any line.
void MergedHull::link(VertexId from, VertexId to, std::vector<VertexId>& between) {
  std::sort(between.begin(), between.end());
  if (from > to) std::reverse(between.begin(), between.end());
  between.push_back(to);
  for (const VertexId v : between) {
    hull_.next[from] = v;
    previous_[v] = from;
    from = v;
  }
}

void MergedHull::collect() {
  VertexId v = start_;
  do {
    if (isCorner(previous_[v], v, hull_.next[v])) result_.push_back(rings_.point(v));
    v = hull_.next[v];
  } while (v != start_);
}

}  // namespace lodestone
