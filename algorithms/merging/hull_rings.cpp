#include "algorithms/merging/hull_rings.h"

#include <algorithm>

#include "algorithms/geometry/predicates.h"

namespace lodestone {
void HullRings::assign(std::span<const std::span<const Vec2>> rings) {
  numberVertices(rings);
  nodes_.clear();
  roots_.clear();
  for (std::size_t r = 0; r < rings.size(); ++r) growTree(ringStart_[r], ringStart_[r + 1]);
}

void HullRings::numberVertices(std::span<const std::span<const Vec2>> rings) {
  entries_.clear();
  ringStart_.assign(1, 0);
  ringOf_.clear();
  for (const std::span<const Vec2> ring : rings) {
    for (const Vec2& p : ring) entries_.push_back({p, static_cast<RingPlace>(entries_.size())});
    ringOf_.resize(entries_.size(), static_cast<std::uint32_t>(ringStart_.size() - 1));
    ringStart_.push_back(static_cast<RingPlace>(entries_.size()));
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    if (a.point.x() != b.point.x()) return a.point.x() < b.point.x();
    return a.point.y() != b.point.y() ? a.point.y() < b.point.y() : a.place < b.place;
  });
  points_.clear();
  placeStart_.clear();
  places_.resize(entries_.size());
  vertexAt_.resize(entries_.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (points_.empty() || points_.back() != entries_[i].point) {
      points_.push_back(entries_[i].point);
      placeStart_.push_back(static_cast<std::uint32_t>(i));
    }
    places_[i] = entries_[i].place;
    vertexAt_[entries_[i].place] = static_cast<VertexId>(points_.size() - 1);
  }
  placeStart_.push_back(static_cast<std::uint32_t>(entries_.size()));
}

void HullRings::growTree(RingPlace begin, RingPlace end) {
  auto level = static_cast<std::uint32_t>(nodes_.size());
  for (RingPlace place = begin; place < end; place += kFanOut) {
    Node node{{}, place, std::min(place + kFanOut, end)};
    for (RingPlace p = node.begin; p < node.end; ++p) node.box.add(points_[vertexAt_[p]]);
    node.box.add(points_[vertexAt_[next(node.end - 1)]]);
    nodes_.push_back(node);
  }
  while (nodes_.size() - level > 1) {
    const auto levelEnd = static_cast<std::uint32_t>(nodes_.size());
    for (std::uint32_t child = level; child < levelEnd; child += kFanOut) {
      const std::uint32_t childEnd = std::min(child + kFanOut, levelEnd);
      Node node{{}, nodes_[child].begin, nodes_[childEnd - 1].end, child, childEnd - child};
      for (std::uint32_t c = child; c < childEnd; ++c) node.box.add(nodes_[c].box);
      nodes_.push_back(node);
    }
    level = levelEnd;
  }
  roots_.push_back(level);
}

Box2 HullRings::boxOf(const RingChain& chain) const {
  Box2 box;
  const auto addRange = [&](RingPlace begin, RingPlace end, const auto& self, std::uint32_t index) -> void {
    const Node& n = nodes_[index];
    if (n.end <= begin || n.begin >= end) return;
    if (n.begin >= begin && n.end <= end) {
      box.add(n.box);
    } else if (n.childCount == 0) {
      for (RingPlace p = std::max(n.begin, begin); p < std::min(n.end, end); ++p) {
        box.add(points_[vertexAt_[p]]);
        box.add(points_[vertexAt_[next(p)]]);
      }
    } else {
      for (std::uint32_t c = 0; c < n.childCount; ++c) self(begin, end, self, n.firstChild + c);
    }
  };
  const std::uint32_t top = roots_[chain.ring];
  if (chain.wraps()) {
    addRange(chain.first, nodes_[top].end, addRange, top);
    addRange(nodes_[top].begin, chain.last, addRange, top);
  } else {
    addRange(chain.first, chain.last, addRange, top);
  }
  return box;
}

}  // namespace lodestone
