// The rings whose merged hull is sought, prepared for searching: equal vertices numbered once, and a tree of
// boxes along each ring.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

using VertexId = std::uint32_t;  ///< a place where one or more rings have a vertex; ordered by x, then y
using RingPlace =
    std::uint32_t;  ///< a vertex of a ring, all rings one after another; side i goes from place i to next(i)
inline constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

/// The part of one ring between two of its vertices, along the ring: places first … last, where last may have
/// wrapped past the ring's end.
struct RingChain {
  std::uint32_t ring = 0;
  RingPlace first = 0;
  RingPlace last = 0;
  [[nodiscard]] bool wraps() const { return last < first; }
};

class HullRings {
 public:
  /// Sides in a lowest node, and children of a higher one: boxes of fewer cost more than they save, of more
  /// hold back less.
  static constexpr std::uint32_t kFanOut = 8;

  struct Node {
    Box2 box;  ///< of the sides [begin, end), both their ends
    RingPlace begin = 0;
    RingPlace end = 0;
    std::uint32_t firstChild = 0;
    std::uint32_t childCount = 0;  ///< 0 for the nodes just above the sides
  };

  /// Memory is kept from one call to the next. \pre no ring is empty.
  void assign(std::span<const std::span<const Vec2>> rings);

  [[nodiscard]] std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(points_.size()); }
  [[nodiscard]] const Vec2& point(VertexId v) const { return points_[v]; }
  [[nodiscard]] VertexId vertexAt(RingPlace place) const { return vertexAt_[place]; }
  [[nodiscard]] RingPlace next(RingPlace place) const {
    return place + 1 == ringStart_[ringOf_[place] + 1] ? ringStart_[ringOf_[place]] : place + 1;
  }
  [[nodiscard]] RingPlace previous(RingPlace place) const {
    return place == ringStart_[ringOf_[place]] ? ringStart_[ringOf_[place] + 1] - 1 : place - 1;
  }
  [[nodiscard]] std::uint32_t ringOf(RingPlace place) const { return ringOf_[place]; }
  [[nodiscard]] std::span<const RingPlace> placesOf(VertexId v) const {
    return {places_.data() + placeStart_[v], placeStart_[v + 1] - placeStart_[v]};
  }
  [[nodiscard]] std::uint32_t ringCount() const { return static_cast<std::uint32_t>(roots_.size()); }
  [[nodiscard]] std::uint32_t root(std::uint32_t ring) const { return roots_[ring]; }
  [[nodiscard]] const Node& node(std::uint32_t index) const { return nodes_[index]; }
  /// Box around the chain's vertices.
  [[nodiscard]] Box2 boxOf(const RingChain& chain) const;

 private:
  void numberVertices(std::span<const std::span<const Vec2>> rings);
  void growTree(RingPlace begin, RingPlace end);

  struct Entry {
    Vec2 point;
    RingPlace place;
  };
  std::vector<Entry> entries_;
  std::vector<Vec2> points_;
  std::vector<VertexId> vertexAt_;
  std::vector<std::uint32_t> ringOf_;
  std::vector<RingPlace> ringStart_;
  std::vector<std::uint32_t> placeStart_;
  std::vector<RingPlace> places_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> roots_;
};

}  // namespace lodestone
