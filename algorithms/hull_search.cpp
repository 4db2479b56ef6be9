#include "algorithms/hull_search.h"

#include <algorithm>
#include <array>

namespace lodestone {
namespace {

bool meet(const Box2& a, const Box2& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

/// Sides of a triangle a‑b‑p (counter-clockwise) on which a point lies: −1 outside, 0 on the line, 1 inside.
struct Sides {
  std::array<int, 3> at;
  Sides(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q)
      : at{orientation(a, b, q), orientation(b, p, q), orientation(p, a, q)} {}
  [[nodiscard]] bool inside() const { return at[0] > 0 && at[1] > 0 && at[2] > 0; }
  [[nodiscard]] bool outside() const { return at[0] < 0 || at[1] < 0 || at[2] < 0; }
};

/// True when the segment c–d meets the open triangle: no side and not the segment's own line separates the
/// two.
bool meetsInside(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& c, const Sides& atC, const Vec2& d,
                 const Sides& atD) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (atC.at[i] <= 0 && atD.at[i] <= 0) return false;
  }
  if (atC.inside() || atD.inside()) return true;
  const int ofA = orientation(c, d, a);
  const int ofB = orientation(c, d, b);
  const int ofP = orientation(c, d, p);
  return (ofA > 0 || ofB > 0 || ofP > 0) && (ofA < 0 || ofB < 0 || ofP < 0);
}

/// True when c→d covers a→b, all four on one line: the edge runs along a side of a ring.
bool runsAlong(const Vec2& a, const Vec2& b, const Vec2& c, const Sides& atC, const Vec2& d,
               const Sides& atD) {
  return atC.at[0] == 0 && atD.at[0] == 0 && (b - a).dot(d - c) > 0 && onSegment(c, d, a) &&
         onSegment(c, d, b);
}

}  // namespace

bool HullSearch::isBridge(VertexId a, VertexId b) const {
  for (const RingPlace i : rings_.placesOf(a)) {
    for (const RingPlace j : rings_.placesOf(b)) {
      if (rings_.ringOf(i) == rings_.ringOf(j)) return false;
    }
  }
  return true;
}

/// Finds the chain that encloses the edge's free space. False when the edge is a side of a ring.
bool HullSearch::enclose(VertexId a, VertexId b) {
  chain_.reset();
  for (const RingPlace i : rings_.placesOf(a)) {
    for (const RingPlace j : rings_.placesOf(b)) {
      if (rings_.ringOf(i) != rings_.ringOf(j)) continue;
      if (rings_.next(i) == j) return false;
      if (simple_ && !chain_) chain_ = RingChain{rings_.ringOf(i), i, j};
    }
  }
  if (chain_) chainBox_ = rings_.boxOf(*chain_);
  return true;
}

/// The chain's two ends bound the angles of every open triangle.
void HullSearch::seed(VertexId a, VertexId b) {
  shadows_.clear();
  if (!chain_) return;
  const VertexId afterA = rings_.vertexAt(rings_.next(chain_->first));
  const VertexId beforeB = rings_.vertexAt(rings_.previous(chain_->last));
  for (const auto& [end, inner] : {std::pair(a, afterA), std::pair(b, beforeB)}) {
    if (orientation(rings_.point(a), rings_.point(b), rings_.point(inner)) > 0) refute(a, b, end, inner);
  }
}

bool HullSearch::inChain(RingPlace place) const {
  return chain_->wraps() ? place >= chain_->first || place < chain_->last
                         : place >= chain_->first && place < chain_->last;
}

/// False when nothing of the node can matter to the edge at hand.
bool HullSearch::reaches(const HullRings::Node& node) const {
  if (!chain_) return true;
  if (rings_.ringOf(node.begin) != chain_->ring) return meet(node.box, chainBox_);
  if (chain_->wraps()) return node.end > chain_->first || node.begin < chain_->last;
  return node.end > chain_->first && node.begin < chain_->last;
}

/// No vertex in the box makes a triangle whose area is computed as larger.
double HullSearch::bound(VertexId a, VertexId b, const Box2& box) const {
  const Vec2& from = rings_.point(a);
  const Vec2& to = rings_.point(b);
  const Vec2 corner = Shadow::rightmostCorner(box, to, from);  // the one furthest to the left of a→b
  const double reach = (box.min - from).cwiseAbs().maxCoeff() + (box.max - from).cwiseAbs().maxCoeff();
  constexpr double kRounding = 1e-14;  // of two products and three differences, with room to spare
  return doubledArea(from, to, corner) + kRounding * (to - from).lpNorm<1>() * reach;
}

template <class What>
bool HullSearch::inShadow(const What& what, std::uint32_t from) const {
  for (std::size_t i = from; i < shadows_.size(); ++i) {
    if (shadows_[i].covers(what)) return true;
  }
  return false;
}

bool HullSearch::later(const Item& x, const Item& y) {
  if (x.key != y.key) return x.key < y.key;
  if (x.isNode != y.isNode) return y.isNode;  // a node may hold an equal triangle with a smaller vertex
  return x.index > y.index;
}

void HullSearch::push(Item item) {
  heap_.push_back(item);
  std::push_heap(heap_.begin(), heap_.end(), later);
}

/// Puts what is below a node on the heap.
void HullSearch::open(VertexId a, VertexId b, const HullRings::Node& node) {
  const auto seen = static_cast<std::uint32_t>(shadows_.size());
  for (std::uint32_t c = 0; c < node.childCount; ++c) {
    const HullRings::Node& child = rings_.node(node.firstChild + c);
    if (!reaches(child)) continue;
    const double key = bound(a, b, child.box);
    if (key > 0 && !inShadow(child.box, 0)) push({key, node.firstChild + c, true, seen});
  }
  if (node.childCount > 0) return;
  const bool ownRing = chain_ && rings_.ringOf(node.begin) == chain_->ring;
  for (RingPlace place = node.begin; place < node.end; ++place) {
    if (ownRing && !inChain(place)) continue;
    const VertexId v = rings_.vertexAt(place);
    if (hull_.on(v) || orientation(rings_.point(a), rings_.point(b), rings_.point(v)) <= 0) continue;
    if (inShadow(rings_.point(v), 0)) continue;
    push({doubledArea(rings_.point(a), rings_.point(b), rings_.point(v)), v, false, seen});
  }
}

std::optional<Division> HullSearch::largest(VertexId a, VertexId b) {
  if (!enclose(a, b)) return std::nullopt;
  seed(a, b);
  heap_.clear();
  for (std::uint32_t r = 0; r < rings_.ringCount(); ++r) {
    const HullRings::Node& root = rings_.node(rings_.root(r));
    if (reaches(root)) open(a, b, root);
  }
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Item item = heap_.back();
    heap_.pop_back();
    if (item.isNode) {
      const HullRings::Node& node = rings_.node(item.index);
      if (!inShadow(node.box, item.shadowsSeen)) open(a, b, node);
      continue;
    }
    if (inShadow(rings_.point(item.index), item.shadowsSeen)) continue;
    const Probe found = probe(a, b, item.index);
    if (found == Probe::Closed) return std::nullopt;
    if (found == Probe::Open) return Division{item.key, item.index, a, b};
  }
  return std::nullopt;
}

bool HullSearch::isOpen(const Division& division) {
  if (hull_.on(division.p) || !enclose(division.a, division.b)) return false;
  shadows_.clear();
  return probe(division.a, division.b, division.p) == Probe::Open;
}

HullSearch::Probe HullSearch::refute(VertexId a, VertexId b, VertexId c, VertexId d) {
  shadows_.emplace_back(rings_.point(a), rings_.point(b), rings_.point(c), rings_.point(d));
  return Probe::Refuted;
}

HullSearch::Probe HullSearch::probe(VertexId a, VertexId b, VertexId p) {
  onSides_.clear();
  Probe result = Probe::Open;
  for (std::uint32_t r = 0; r < rings_.ringCount() && result == Probe::Open; ++r) {
    result = probeNode(rings_.node(rings_.root(r)), a, b, p);
  }
  return result == Probe::Open ? probeBridges(a, b, p) : result;
}

/// Looks for sides inside the triangle, the nearest boxes to the edge first: what is near throws the larger
/// shadow.
HullSearch::Probe HullSearch::probeNode(const HullRings::Node& node, VertexId a, VertexId b, VertexId p) {
  const std::array<const Vec2*, 3> corners{&rings_.point(a), &rings_.point(b), &rings_.point(p)};
  const auto apart = [&](const Box2& box) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2& from = *corners[i];
      const Vec2& to = *corners[(i + 1) % 3];
      if (orientation(from, to, Shadow::rightmostCorner(box, to, from)) < 0) return true;
    }
    Box2 triangle;
    for (const Vec2* corner : corners) triangle.add(*corner);
    return !meet(box, triangle);
  };
  if (!reaches(node) || apart(node.box)) return Probe::Open;
  if (node.childCount == 0) return probeSides(node, a, b, p);
  std::array<std::pair<double, std::uint32_t>, 16> near;
  std::size_t count = 0;
  for (std::uint32_t c = 0; c < node.childCount; ++c) {
    const Box2& box = rings_.node(node.firstChild + c).box;
    near[count++] = {
        doubledArea(*corners[0], *corners[1], Shadow::rightmostCorner(box, *corners[0], *corners[1])), c};
  }
  std::sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const Probe result = probeNode(rings_.node(node.firstChild + near[i].second), a, b, p);
    if (result != Probe::Open) return result;
  }
  return Probe::Open;
}

HullSearch::Probe HullSearch::probeSides(const HullRings::Node& node, VertexId a, VertexId b, VertexId p) {
  const Vec2& pa = rings_.point(a);
  const Vec2& pb = rings_.point(b);
  const Vec2& pp = rings_.point(p);
  const bool ownRing = chain_ && rings_.ringOf(node.begin) == chain_->ring;
  for (RingPlace place = node.begin; place < node.end; ++place) {
    if (ownRing && !inChain(place)) continue;
    const VertexId c = rings_.vertexAt(place);
    const VertexId d = rings_.vertexAt(rings_.next(place));
    const Vec2& pc = rings_.point(c);
    const Vec2& pd = rings_.point(d);
    const Sides atC(pa, pb, pp, pc);
    const Sides atD(pa, pb, pp, pd);
    if (meetsInside(pa, pb, pp, pc, atC, pd, atD)) return refute(a, b, c, d);
    if (runsAlong(pa, pb, pc, atC, pd, atD)) return Probe::Closed;
    if (c == a || c == b || c == p || atC.outside()) continue;
    if (hull_.on(c)) return Probe::Refuted;  // the hull would touch itself there
    onSides_.push_back(c);
  }
  return Probe::Open;
}

HullSearch::Probe HullSearch::probeBridges(VertexId a, VertexId b, VertexId p) {
  if (hull_.bridges.empty() || !isBridge(a, b)) return Probe::Open;
  const Vec2& pa = rings_.point(a);
  const Vec2& pb = rings_.point(b);
  const Vec2& pp = rings_.point(p);
  for (const VertexId c : hull_.bridges) {
    if (c == a) continue;
    const VertexId d = hull_.next[c];
    const Sides atC(pa, pb, pp, rings_.point(c));
    const Sides atD(pa, pb, pp, rings_.point(d));
    if (meetsInside(pa, pb, pp, rings_.point(c), atC, rings_.point(d), atD)) return refute(a, b, c, d);
  }
  return Probe::Open;
}

}  // namespace lodestone
