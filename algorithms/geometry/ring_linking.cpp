#include "algorithms/geometry/ring_linking.h"

#include <algorithm>
#include <limits>

#include "algorithms/geometry/predicates.h"

namespace lodestone {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// True when `second` comes before `first` in a clockwise turn about `centre` that starts at `from`.
bool earlierClockwise(const Vec2& centre, const Vec2& from, const Vec2& first, const Vec2& second) {
  const auto half = [&](const Vec2& p) {  // 0: within the first half turn clockwise, 1: within the second
    const int turn = orientation(centre, from, p);
    if (turn != 0) return turn < 0 ? 0 : 1;
    return (p - centre).dot(from - centre) > 0 ? 2
                                               : 0;  // opposite counts as first half; the same way comes last
  };
  const int a = half(first);
  const int b = half(second);
  if (a != b) return b < a;
  return orientation(centre, first, second) > 0;
}

/// Directed edges by the vertex where they start.
class Outgoing {
 public:
  Outgoing(std::size_t vertexCount, std::vector<DirectedEdge> edges)
      : edges_(std::move(edges)), start_(vertexCount + 1, 0) {
    std::sort(edges_.begin(), edges_.end());
    for (const DirectedEdge& edge : edges_) ++start_[edge[0] + 1];
    for (std::size_t v = 0; v < vertexCount; ++v) start_[v + 1] += start_[v];
    used_.assign(edges_.size(), false);
  }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(edges_.size()); }
  [[nodiscard]] bool used(std::uint32_t edge) const { return used_[edge]; }
  [[nodiscard]] const DirectedEdge& operator[](std::uint32_t edge) const { return edges_[edge]; }
  void use(std::uint32_t edge) { used_[edge] = true; }

  /// The unused edge that bounds the same corner of the inside as `edge` does at its end.
  [[nodiscard]] std::uint32_t next(const std::vector<Vec2>& points, std::uint32_t edge) const {
    const auto [from, at] = edges_[edge];
    std::uint32_t best = kNone;
    for (std::uint32_t e = start_[at]; e < start_[at + 1]; ++e) {
      if (used_[e]) continue;
      if (best == kNone ||
          earlierClockwise(points[at], points[from], points[edges_[best][1]], points[edges_[e][1]]))
        best = e;
    }
    return best;
  }

 private:
  std::vector<DirectedEdge> edges_;
  std::vector<std::uint32_t> start_;
  std::vector<bool> used_;
};

/// Removes vertices in the middle of straight sides and at the tips of spikes.
Ring withoutCollinear(Ring ring) {
  for (bool changed = true; changed && ring.size() >= 3;) {
    changed = false;
    for (std::size_t i = 0; i < ring.size() && ring.size() >= 3;) {
      const std::size_t n = ring.size();
      if (orientation(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]) == 0) {
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
        changed = true;
      } else {
        ++i;
      }
    }
  }
  if (ring.size() < 3) ring.clear();
  return ring;
}

/// Starts the ring at its smallest vertex.
void rotateToSmallest(Ring& ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), lexicographicallyLess), ring.end());
}

/// Follows the edges; whenever a walk comes back to a vertex, the loop since then is a ring of its own.
std::vector<Ring> walkRings(const std::vector<Vec2>& points, Outgoing& outgoing) {
  std::vector<Ring> rings;
  std::vector<std::uint32_t> place(points.size(), kNone);  // of a vertex in the present walk
  std::vector<std::uint32_t> walk;
  for (std::uint32_t start = 0; start < outgoing.size(); ++start) {
    for (std::uint32_t edge = start; edge != kNone && !outgoing.used(edge);
         edge = outgoing.next(points, edge)) {
      outgoing.use(edge);
      const auto [from, to] = outgoing[edge];
      if (place[from] == kNone) {
        place[from] = static_cast<std::uint32_t>(walk.size());
        walk.push_back(from);
      }
      if (place[to] == kNone) continue;
      Ring ring;
      for (std::size_t k = place[to]; k < walk.size(); ++k) ring.push_back(points[walk[k]]);
      while (walk.size() > place[to] + 1) {
        place[walk.back()] = kNone;
        walk.pop_back();
      }
      ring = withoutCollinear(std::move(ring));
      if (!ring.empty()) rings.push_back(std::move(ring));
    }
    for (const std::uint32_t v : walk) place[v] = kNone;
    walk.clear();
  }
  return rings;
}

/// A point of `ring` that is not on `other`, seen from `other`; rings that do not cross are wholly on one
/// side.
bool inside(const Ring& ring, const Ring& other) {
  for (const Vec2& p : ring) {
    const Side side = sideOf(other, p);
    if (side != Side::Boundary) return side == Side::Inside;
  }
  Vec2 middle = (ring[0] + ring[1]) / 2;
  return sideOf(other, middle) == Side::Inside;
}

}  // namespace

MultiPolygon linkRings(const std::vector<Vec2>& points, const std::vector<DirectedEdge>& edges) {
  Outgoing outgoing(points.size(), edges);
  std::vector<Ring> rings = walkRings(points, outgoing);
  for (Ring& ring : rings) rotateToSmallest(ring);
  std::sort(rings.begin(), rings.end(), [](const Ring& a, const Ring& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), lexicographicallyLess);
  });
  MultiPolygon result;
  for (const Ring& ring : rings) {
    if (signedArea(ring) > 0) result.push_back({ring, {}});
  }
  for (const Ring& ring : rings) {
    if (signedArea(ring) > 0) continue;
    Polygon* around = nullptr;  // the smallest outer ring around the hole
    for (Polygon& polygon : result) {
      const bool smaller = around == nullptr || signedArea(polygon.outer) < signedArea(around->outer);
      if (smaller && inside(ring, polygon.outer)) around = &polygon;
    }
    if (around != nullptr) around->holes.push_back(ring);
  }
  return result;
}

}  // namespace lodestone
