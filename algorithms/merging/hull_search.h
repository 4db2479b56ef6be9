// The largest triangle by which an edge of a merged hull can be divided.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/merging/hull_rings.h"
#include "algorithms/merging/hull_shadow.h"

namespace lodestone {

/// A way to divide the edge a→b: put p between.
struct Division {
  double doubledArea = 0;  ///< of the triangle a‑p‑b, as doubles have it
  VertexId p = kNoVertex;
  VertexId a = kNoVertex;
  VertexId b = kNoVertex;

  /// Order of the greedy choice: the larger triangle first; of equal ones that with the smaller p, then the
  /// smaller a (vertices by x, then y).
  [[nodiscard]] bool comesBefore(const Division& other) const {
    if (doubledArea != other.doubledArea) return doubledArea > other.doubledArea;
    return p != other.p ? p < other.p : a < other.a;
  }
};

/// (b − a) × (p − a): twice the area of a triangle, compared as computed in doubles.
[[nodiscard]] inline double doubledArea(const Vec2& a, const Vec2& b, const Vec2& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

/// What HullSearch needs to know of the hull as it stands.
struct HullState {
  std::vector<VertexId> next;     ///< counter-clockwise; kNoVertex for vertices that are not on the hull
  std::vector<VertexId> bridges;  ///< starts of the edges whose ends are on no common ring
  [[nodiscard]] bool on(VertexId v) const { return next[v] != kNoVertex; }
};

/// Finds divisions. A division is open when the triangle leaves the hull simple and cuts no ring: nothing but
/// its edge is on the hull, and no side of a ring meets its inside.
///
/// Far vertices are looked at first, by the tree of boxes. A side found inside a triangle refutes it and
/// throws a shadow; boxes in a shadow are never opened. So the cost of an edge is about the number of sides
/// that can be seen from it, times a logarithm. Where both ends are on one simple ring the search keeps to
/// the chain between them and to what lies in the chain's box, because the chain and the edge enclose all
/// that can be reached.
class HullSearch {
 public:
  HullSearch(const HullRings& rings, const HullState& hull) : rings_(rings), hull_(hull) {}
  /// To be called when the rings were assigned anew. `simple`: they are all simple and counter-clockwise.
  void begin(bool simple) { simple_ = simple; }

  /// The largest open division of the edge, if it has any.
  [[nodiscard]] std::optional<Division> largest(VertexId a, VertexId b);
  /// True when the division is still open; its vertices on the two new sides are then in onSides().
  [[nodiscard]] bool isOpen(const Division& division);
  [[nodiscard]] const std::vector<VertexId>& onSides() const { return onSides_; }
  /// True when the ends are on no common ring: then other edges of the hull may border on the same free
  /// space.
  [[nodiscard]] bool isBridge(VertexId a, VertexId b) const;

 private:
  enum class Probe { Open, Refuted, Closed };  ///< Closed: no triangle on this edge is open
  struct Item {
    double key;           ///< doubled area, or a bound on those of a node
    std::uint32_t index;  ///< of a node, or a vertex
    bool isNode;
    std::uint32_t shadowsSeen;  ///< the item is in none of the first so many shadows
  };

  bool enclose(VertexId a, VertexId b);
  void seed(VertexId a, VertexId b);
  void open(VertexId a, VertexId b, const HullRings::Node& node);
  static bool later(const Item& x, const Item& y);
  void push(Item item);
  [[nodiscard]] double bound(VertexId a, VertexId b, const Box2& box) const;
  template <class What>
  [[nodiscard]] bool inShadow(const What& what, std::uint32_t from) const;
  [[nodiscard]] bool reaches(const HullRings::Node& node) const;
  [[nodiscard]] bool inChain(RingPlace place) const;

  struct Triangle;
  Probe probe(VertexId a, VertexId b, VertexId p);
  Probe probeNode(const HullRings::Node& node, const Triangle& triangle);
  Probe probeSides(const HullRings::Node& node, const Triangle& triangle);
  Probe probeBridges(const Triangle& triangle);
  Probe refute(VertexId a, VertexId b, VertexId c, VertexId d);

  const HullRings& rings_;
  const HullState& hull_;
  bool simple_ = true;
  std::optional<RingChain> chain_;  ///< of the edge at hand, and the box around it
  Box2 chainBox_;
  std::vector<Item> heap_;
  std::vector<Shadow> shadows_;
  std::vector<VertexId> onSides_;
};

}  // namespace lodestone
