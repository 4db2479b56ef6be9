#include "algorithms/merging/hull_search.h"

#include <algorithm>
#include <array>

namespace lodestone {
namespace {

bool meet(const Box2& a, const Box2& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

/// Where a point lies to the sides of a triangle: −1 outside, 0 on the line, 1 inside.
using Sides = std::array<int, 3>;

bool outside(const Sides& at) {
  return at[0] < 0 || at[1] < 0 || at[2] < 0;
}

}  // namespace

/// a‑b‑p, counter-clockwise.
struct HullSearch::Triangle {
  VertexId a, b, p;
  const Vec2& pa;
  const Vec2& pb;
  const Vec2& pp;
  Box2 box;

  Triangle(const HullRings& rings, VertexId va, VertexId vb, VertexId vp)
      : a(va), b(vb), p(vp), pa(rings.point(va)), pb(rings.point(vb)), pp(rings.point(vp)) {
    for (const Vec2* corner : {&pa, &pb, &pp}) box.add(*corner);
  }

  [[nodiscard]] Sides sidesOf(const Vec2& q) const {
    return {orientation(pa, pb, q), orientation(pb, pp, q), orientation(pp, pa, q)};
  }

  /// True when one of the sides separates the box from the triangle.
  [[nodiscard]] bool apartFrom(const Box2& other) const {
    const auto beyond = [&](const Vec2& from, const Vec2& to) {
      return orientation(from, to, Shadow::rightmostCorner(other, to, from)) < 0;
    };
    return !meet(other, box) || beyond(pa, pb) || beyond(pb, pp) || beyond(pp, pa);
  }

  /// True when the segment c–d meets the open triangle: neither a side nor the segment's own line separates
  /// the two.
  [[nodiscard]] bool isEnteredBy(const Vec2& c, const Sides& atC, const Vec2& d, const Sides& atD) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (atC[i] <= 0 && atD[i] <= 0) return false;
    }
    const int ofA = orientation(c, d, pa);
    const int ofB = orientation(c, d, pb);
    const int ofP = orientation(c, d, pp);
    return (ofA > 0 || ofB > 0 || ofP > 0) && (ofA < 0 || ofB < 0 || ofP < 0);
  }

  /// True when c→d covers a→b, all four on one line: the edge runs along a side of a ring.
  [[nodiscard]] bool standsOn(const Vec2& c, const Sides& atC, const Vec2& d, const Sides& atD) const {
    return atC[0] == 0 && atD[0] == 0 && (pb - pa).dot(d - c) > 0 && onSegment(c, d, pa) &&
           onSegment(c, d, pb);
  }
};

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
  const Triangle triangle(rings_, a, b, p);
  Probe result = Probe::Open;
  for (std::uint32_t r = 0; r < rings_.ringCount() && result == Probe::Open; ++r) {
    result = probeNode(rings_.node(rings_.root(r)), triangle);
  }
  return result == Probe::Open ? probeBridges(triangle) : result;
}

/// Looks for sides inside the triangle, the nearest boxes to the edge first: what is near throws the larger
/// shadow.
HullSearch::Probe HullSearch::probeNode(const HullRings::Node& node, const Triangle& triangle) {
  if (!reaches(node) || triangle.apartFrom(node.box)) return Probe::Open;
  if (node.childCount == 0) return probeSides(node, triangle);
  std::array<std::pair<double, std::uint32_t>, HullRings::kFanOut> near;
  for (std::uint32_t c = 0; c < node.childCount; ++c) {
    const Vec2 nearest =
        Shadow::rightmostCorner(rings_.node(node.firstChild + c).box, triangle.pa, triangle.pb);
    near[c] = {doubledArea(triangle.pa, triangle.pb, nearest), c};
  }
  std::sort(near.begin(), near.begin() + node.childCount);
  for (std::uint32_t i = 0; i < node.childCount; ++i) {
    const Probe result = probeNode(rings_.node(node.firstChild + near[i].second), triangle);
    if (result != Probe::Open) return result;
  }
  return Probe::Open;
}

HullSearch::Probe HullSearch::probeSides(const HullRings::Node& node, const Triangle& triangle) {
  const bool ownRing = chain_ && rings_.ringOf(node.begin) == chain_->ring;
  const auto clear = [&](const Vec2& c, const Vec2& d) {  // of the triangle's box
    const Box2& box = triangle.box;
    return std::max(c.x(), d.x()) < box.min.x() || std::min(c.x(), d.x()) > box.max.x() ||
           std::max(c.y(), d.y()) < box.min.y() || std::min(c.y(), d.y()) > box.max.y();
  };
  VertexId known =
      kNoVertex;  // the vertex that atKnown is about: each is the end of one side and the start of the next
  Sides atKnown{};
  for (RingPlace place = node.begin; place < node.end; ++place) {
    if (ownRing && !inChain(place)) continue;
    const VertexId c = rings_.vertexAt(place);
    const VertexId d = rings_.vertexAt(rings_.next(place));
    const Vec2& pc = rings_.point(c);
    const Vec2& pd = rings_.point(d);
    if (clear(pc, pd)) continue;
    const Sides atC = c == known ? atKnown : triangle.sidesOf(pc);
    const Sides atD = triangle.sidesOf(pd);
    known = d;
    atKnown = atD;
    if (triangle.isEnteredBy(pc, atC, pd, atD)) return refute(triangle.a, triangle.b, c, d);
    if (triangle.standsOn(pc, atC, pd, atD)) return Probe::Closed;
    if (c == triangle.a || c == triangle.b || c == triangle.p || outside(atC)) continue;
    if (hull_.on(c)) return Probe::Refuted;  // the hull would touch itself there
    onSides_.push_back(c);
  }
  return Probe::Open;
}

HullSearch::Probe HullSearch::probeBridges(const Triangle& triangle) {
  if (hull_.bridges.empty() || !isBridge(triangle.a, triangle.b)) return Probe::Open;
  for (const VertexId c : hull_.bridges) {
    if (c == triangle.a) continue;
    const VertexId d = hull_.next[c];
    const Vec2& pc = rings_.point(c);
    const Vec2& pd = rings_.point(d);
    if (triangle.isEnteredBy(pc, triangle.sidesOf(pc), pd, triangle.sidesOf(pd)))
      return refute(triangle.a, triangle.b, c, d);
  }
  return Probe::Open;
}

}  // namespace lodestone
