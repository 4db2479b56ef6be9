#include "algorithms/geometry/meshing.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "algorithms/geometry/constrained_triangulation.h"
#include "algorithms/geometry/predicates.h"

namespace lodestone {
namespace {

/// Rings of one surface in a plane, without repeated points; `source` numbers the points as the caller does.
struct FlatRings {
  std::vector<Vec2> points;
  std::vector<std::uint32_t> source;
  std::vector<std::uint32_t> ringStart{0};

  void clear() {
    points.clear();
    source.clear();
    ringStart.assign(1, 0);
  }
  void add(const Vec2& point, std::uint32_t from) {
    if (points.size() > ringStart.back() && points.back() == point) return;
    points.push_back(point);
    source.push_back(from);
  }
  /// Closes the ring being built; one without three points is forgotten.
  void finish() {
    const std::uint32_t begin = ringStart.back();
    while (points.size() > begin + 1 && points.back() == points[begin]) pop();
    if (points.size() < begin + 3) {
      while (points.size() > begin) pop();
      return;
    }
    ringStart.push_back(static_cast<std::uint32_t>(points.size()));
  }
  void reverseRing(std::size_t ring) {
    std::reverse(points.begin() + ringStart[ring], points.begin() + ringStart[ring + 1]);
    std::reverse(source.begin() + ringStart[ring], source.begin() + ringStart[ring + 1]);
  }
  [[nodiscard]] std::size_t ringCount() const { return ringStart.size() - 1; }

 private:
  void pop() {
    points.pop_back();
    source.pop_back();
  }
};

/// Counter-clockwise, no collinear corner, and once around only.
bool isStrictlyConvex(std::span<const Vec2> ring) {
  const std::size_t n = ring.size();
  int descents =
      0;  // times that the ring starts to go back in lexicographic order: once for a simple convex ring
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % n];
    const Vec2& c = ring[(i + 2) % n];
    if (orientation(a, b, c) <= 0) return false;
    if (before(a, b) && before(c, b)) ++descents;
  }
  return descents == 1;
}

/// Cuts ears off one counter-clockwise ring. Ears are strict: no other point lies in the closed ear, so that
/// no point is ever left on a diagonal. Cost: n² where ears abound.
class EarClipper {
 public:
  explicit EarClipper(std::span<const Vec2> ring) : ring_(ring), left_(ring.size()) {
    for (std::uint32_t i = 0; i < left_.size(); ++i) left_[i] = i;
  }

  /// False if no ear was left before the ring was used up.
  bool clip(std::vector<IndexTriangle>& triangles) {
    std::size_t at = 0;
    for (std::size_t failed = 0; left_.size() > 3;) {
      at %= left_.size();
      if (isEar(at)) {
        cut(at, triangles);
        failed = 0;
      } else if (++failed > left_.size()) {
        return false;
      } else {
        ++at;
      }
    }
    if (turn(1) <= 0) return false;
    cut(1, triangles);
    return true;
  }

  /// Cuts what is left whatever it looks like: ears where there are, else left turns, else any corner.
  void force(std::vector<IndexTriangle>& triangles) {
    while (left_.size() >= 3) {
      std::size_t best = 0;
      int bestRank = -1;
      for (std::size_t i = 0; i < left_.size() && bestRank < 2; ++i) {
        const int rank = isEar(i) ? 2 : turn(i) > 0 ? 1 : 0;
        if (rank > bestRank) {
          best = i;
          bestRank = rank;
        }
      }
      if (turn(best) != 0)
        cut(best, triangles);
      else
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(best));
    }
  }

 private:
  [[nodiscard]] std::uint32_t before(std::size_t at) const {
    return left_[at == 0 ? left_.size() - 1 : at - 1];
  }
  [[nodiscard]] std::uint32_t after(std::size_t at) const {
    return left_[at + 1 == left_.size() ? 0 : at + 1];
  }
  [[nodiscard]] int turn(std::size_t at) const {
    return orientation(ring_[before(at)], ring_[left_[at]], ring_[after(at)]);
  }
  [[nodiscard]] bool isEar(std::size_t at) const {
    if (turn(at) <= 0) return false;
    const std::uint32_t a = before(at);
    const std::uint32_t b = left_[at];
    const std::uint32_t c = after(at);
    return std::none_of(left_.begin(), left_.end(), [&](std::uint32_t i) {
      return i != a && i != b && i != c && orientation(ring_[a], ring_[b], ring_[i]) >= 0 &&
             orientation(ring_[b], ring_[c], ring_[i]) >= 0 && orientation(ring_[c], ring_[a], ring_[i]) >= 0;
    });
  }
  void cut(std::size_t at, std::vector<IndexTriangle>& triangles) {
    triangles.push_back({before(at), left_[at], after(at)});
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
  }

  std::span<const Vec2> ring_;
  std::vector<std::uint32_t> left_;
};

/// Beyond this many corners the quadratic ear clipping loses to the triangulation.
constexpr std::size_t kMostEars = 32;

/// Triangles of rings whose first is the counter-clockwise outer one. False if the rings cross: then only
/// roughly right.
bool triangulateRings(FlatRings& rings, std::vector<IndexTriangle>& triangles) {
  triangles.clear();
  if (rings.ringCount() == 0) return true;
  const std::span<const Vec2> outer(rings.points.data(), rings.ringStart[1]);
  if (rings.ringCount() == 1) {
    if (isStrictlyConvex(outer)) {
      for (std::uint32_t i = 2; i < outer.size(); ++i) triangles.push_back({0, i - 1, i});
      return true;
    }
    if (outer.size() <= kMostEars && EarClipper(outer).clip(triangles)) return true;
    triangles.clear();
  }
  for (std::size_t r = 1; r < rings.ringCount(); ++r) {
    const std::span<const Vec2> hole(rings.points.data() + rings.ringStart[r],
                                     rings.ringStart[r + 1] - rings.ringStart[r]);
    if (signedArea(hole) > 0) rings.reverseRing(r);
  }
  if (constrainedTriangulation(rings.points, rings.ringStart, triangles)) return true;
  EarClipper(outer).force(triangles);
  return false;
}

/// Twice the area vector of a ring (Newell), taken about its first vertex so that large coordinates cost no
/// digits.
Vec3 areaVector(const Geometry& geometry, std::uint32_t ring) {
  const std::uint32_t begin = geometry.ringStart[ring];
  const std::uint32_t end = geometry.ringStart[ring + 1];
  Vec3 sum = Vec3::Zero();
  for (std::uint32_t i = begin + 2; i < end; ++i) {
    const Vec3& origin = geometry.vertices[geometry.ringVertices[begin]];
    sum += (geometry.vertices[geometry.ringVertices[i - 1]] - origin)
               .cross(geometry.vertices[geometry.ringVertices[i]] - origin);
  }
  return sum;
}

/// The two coordinates that are kept when a surface is seen along the axis that it faces most,
/// counter-clockwise.
struct Projection {
  int u = 0;
  int v = 1;
  explicit Projection(const Vec3& normal) {
    int axis = 2;
    for (int i = 1; i >= 0; --i) {
      if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    }
    u = (axis + 1) % 3;
    v = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(u, v);
  }
  [[nodiscard]] Vec2 operator()(const Vec3& p) const { return {p[u], p[v]}; }
};

void addPolygon(Geometry& block, const Polygon& polygon, double bottom, double top) {
  const auto first = static_cast<std::uint32_t>(block.vertices.size());
  std::vector<std::uint32_t> ringStart{first};
  const auto addRing = [&](const Ring& ring) {
    for (const Vec2& p : ring) {
      block.vertices.emplace_back(p.x(), p.y(), bottom);
      block.vertices.emplace_back(p.x(), p.y(), top);
    }
    ringStart.push_back(static_cast<std::uint32_t>(block.vertices.size()));
  };
  addRing(polygon.outer);
  for (const Ring& hole : polygon.holes) addRing(hole);

  const auto closeRing = [&] {
    block.ringStart.push_back(static_cast<std::uint32_t>(block.ringVertices.size()));
  };
  for (std::size_t r = 0; r + 1 < ringStart.size(); ++r) {
    for (std::uint32_t i = ringStart[r + 1]; i > ringStart[r]; i -= 2) block.ringVertices.push_back(i - 2);
    closeRing();
  }
  block.finishSurface({SurfaceType::Ground});
  for (std::size_t r = 0; r + 1 < ringStart.size(); ++r) {
    for (std::uint32_t i = ringStart[r]; i < ringStart[r + 1]; i += 2) {
      const std::uint32_t next = i + 2 < ringStart[r + 1] ? i + 2 : ringStart[r];
      block.ringVertices.insert(block.ringVertices.end(), {i, next, next + 1, i + 1});
      closeRing();
      block.finishSurface({SurfaceType::Wall});
    }
  }
  for (std::size_t r = 0; r + 1 < ringStart.size(); ++r) {
    for (std::uint32_t i = ringStart[r]; i < ringStart[r + 1]; i += 2) block.ringVertices.push_back(i + 1);
    closeRing();
  }
  block.finishSurface({SurfaceType::Roof});
}

}  // namespace

Geometry makeBlock(const MultiPolygon& footprint, double base, double height) {
  Geometry block;
  block.lod = "1.2";
  block.kind = footprint.size() > 1 ? GeometryKind::MultiSolid : GeometryKind::Solid;
  block.shellStart.push_back(0);
  block.solidStart.push_back(0);
  for (const Polygon& polygon : footprint) {
    addPolygon(block, polygon, base, base + height);
    block.shellStart.push_back(static_cast<std::uint32_t>(block.surfaceCount()));
    block.solidStart.push_back(static_cast<std::uint32_t>(block.shellStart.size() - 1));
  }
  return block;
}

std::vector<LevelObject::Triangle> triangulate(const Geometry& geometry, std::vector<std::uint32_t>* broken) {
  std::vector<LevelObject::Triangle> result;
  FlatRings flat;
  std::vector<IndexTriangle> triangles;
  for (std::uint32_t s = 0; s < geometry.surfaceCount(); ++s) {
    const std::uint32_t ringBegin = geometry.surfaceStart[s];
    const std::uint32_t ringEnd = geometry.surfaceStart[s + 1];
    if (ringBegin == ringEnd) continue;
    const Vec3 normal = areaVector(geometry, ringBegin);
    if (normal == Vec3::Zero() || !normal.allFinite()) continue;
    const Projection project(normal);
    flat.clear();
    bool usable = true;
    for (std::uint32_t r = ringBegin; r < ringEnd && usable; ++r) {
      for (std::uint32_t i = geometry.ringStart[r]; i < geometry.ringStart[r + 1]; ++i) {
        const Vec2 point = project(geometry.vertices[geometry.ringVertices[i]]);
        usable = usable && point.allFinite();
        flat.add(point, geometry.ringVertices[i]);
      }
      flat.finish();
      usable = usable && flat.ringCount() > 0;  // without an outer ring its holes mean nothing
    }
    if (!usable) continue;
    if (!triangulateRings(flat, triangles) && broken) broken->push_back(s);
    for (const IndexTriangle& t : triangles) {
      result.push_back({{flat.source[t[0]], flat.source[t[1]], flat.source[t[2]]}, s});
    }
  }
  return result;
}

std::vector<IndexTriangle> triangulate(const Polygon& polygon, bool* broken) {
  // Seen in a mirror, a clockwise ring is counter-clockwise.
  const bool mirrored = signedArea(polygon.outer) < 0;
  FlatRings flat;
  std::uint32_t index = 0;
  const auto addRing = [&](const Ring& ring) {
    for (const Vec2& p : ring) flat.add(mirrored ? Vec2(-p.x(), p.y()) : p, index++);
    flat.finish();
  };
  addRing(polygon.outer);
  if (flat.ringCount() == 0) return {};
  for (const Ring& hole : polygon.holes) addRing(hole);
  const auto finite = [](const Vec2& p) { return p.allFinite(); };
  if (!std::all_of(flat.points.begin(), flat.points.end(), finite)) return {};

  std::vector<IndexTriangle> triangles;
  const bool whole = triangulateRings(flat, triangles);
  if (broken) *broken = !whole;
  for (IndexTriangle& t : triangles) {
    t = {flat.source[t[0]], flat.source[t[1]], flat.source[t[2]]};
    if (mirrored) std::swap(t[1], t[2]);
  }
  return triangles;
}

}  // namespace lodestone
