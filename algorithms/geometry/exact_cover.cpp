// Sides cross seldom and few at a time here: the hierarchy of constraints that CGAL advises would cost more
// than it saves.
#define CGAL_NO_CDT_2_WARNING

#include "algorithms/geometry/exact_cover.h"

#include <algorithm>
#include <cstdint>
#include <map>

#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "algorithms/geometry/predicates.h"
#include "algorithms/geometry/ring_linking.h"

namespace lodestone {
namespace {

struct FaceWinding {
  bool known = false;
  int winding = 0;
};
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using PlainFaceBase = CGAL::Triangulation_face_base_with_info_2<FaceWinding, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, PlainFaceBase>;
using Triangulation =
    CGAL::Constrained_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                      CGAL::Exact_intersections_tag>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

class Cover {
 public:
  explicit Cover(const std::vector<Ring>& rings) {
    std::vector<std::array<Vertex, 2>> sides = insert(rings);
    std::uint32_t count = 0;
    for (Vertex v : triangulation_.finite_vertex_handles()) v->info() = count++;
    for (const auto& [from, to] : sides) countAlong(from, to);
    spread();
  }

  [[nodiscard]] MultiPolygon polygons(CoverRule rule) const {
    if (triangulation_.dimension() < 2) return {};
    std::vector<Vec2> points = roundedPoints();
    const std::vector<std::uint32_t> same = mergeEqual(points);
    std::vector<DirectedEdge> edges;
    for (const Triangulation::Edge& edge : triangulation_.finite_edges()) {
      for (const auto& [face, i] : {edge, triangulation_.mirror_edge(edge)}) {
        if (!inside(face, rule) || inside(face->neighbor(i), rule)) continue;
        const DirectedEdge boundary{same[face->vertex(face->ccw(i))->info()],
                                    same[face->vertex(face->cw(i))->info()]};
        if (boundary[0] != boundary[1]) edges.push_back(boundary);
      }
    }
    return linkRings(points, edges);
  }

 private:
  std::vector<std::array<Vertex, 2>> insert(const std::vector<Ring>& rings) {
    std::vector<std::array<Vertex, 2>> sides;
    for (const Ring& ring : rings) {
      std::vector<Vertex> vertices;
      Face hint;
      for (const Vec2& p : ring) {
        vertices.push_back(triangulation_.insert(Kernel::Point_2(p.x(), p.y()), hint));
        hint = vertices.back()->face();
      }
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vertex next = vertices[(i + 1) % vertices.size()];
        if (vertices[i] != next) sides.push_back({vertices[i], next});
      }
    }
    for (const auto& [from, to] : sides) triangulation_.insert_constraint(from, to);
    return sides;
  }

  /// Adds one passage from → to on every edge of the triangulation that the side was cut into.
  void countAlong(Vertex from, Vertex to) {
    for (Vertex at = from; at != to;) {
      const Vertex next = nextAlong(at, from, to);
      ++passages_[{at->info(), next->info()}];
      at = next;
    }
  }

  [[nodiscard]] Vertex nextAlong(Vertex at, Vertex from, Vertex to) const {
    const auto order = CGAL::compare_xy(from->point(), to->point());
    auto edge = triangulation_.incident_edges(at);
    for (const auto end = edge;;) {
      const auto& [face, i] = *edge;
      const Vertex other =
          face->vertex(face->cw(i)) == at ? face->vertex(face->ccw(i)) : face->vertex(face->cw(i));
      if (other == to) return to;
      if (!triangulation_.is_infinite(other) && face->is_constrained(i) &&
          CGAL::compare_xy(at->point(), other->point()) == order &&
          CGAL::collinear(from->point(), to->point(), other->point())) {
        return other;
      }
      if (++edge == end) return to;  // cannot be: the side is a chain of constrained edges
    }
  }

  [[nodiscard]] int passages(Vertex from, Vertex to) const {
    const auto count = [&](Vertex a, Vertex b) {
      const auto it = passages_.find({a->info(), b->info()});
      return it == passages_.end() ? 0 : it->second;
    };
    return count(from, to) - count(to, from);
  }

  /// Winding numbers of all faces, from the outermost inwards.
  void spread() {
    if (triangulation_.dimension() < 2) return;
    Face outermost = triangulation_.infinite_face();
    outermost->info() = {true, 0};
    std::vector<Face> open{outermost};
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face neighbour = face->neighbor(i);
        if (neighbour->info().known) continue;
        const int across =
            face->is_constrained(i) ? passages(face->vertex(face->ccw(i)), face->vertex(face->cw(i))) : 0;
        neighbour->info() = {true, face->info().winding - across};
        open.push_back(neighbour);
      }
    }
  }

  [[nodiscard]] static bool inside(Face face, CoverRule rule) {
    const int winding = face->info().winding;
    return rule == CoverRule::EvenOdd ? winding % 2 != 0 : winding > 0;
  }

  [[nodiscard]] std::vector<Vec2> roundedPoints() const {
    std::vector<Vec2> points;
    for (Vertex v : triangulation_.finite_vertex_handles()) {
      points.emplace_back(CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y()));
    }
    return points;
  }

  /// Crossings that rounding made equal become one vertex: for each point the first one equal to it.
  [[nodiscard]] static std::vector<std::uint32_t> mergeEqual(const std::vector<Vec2>& points) {
    const auto less = [](const Vec2& a, const Vec2& b) { return lexicographicallyLess(a, b); };
    std::map<Vec2, std::uint32_t, decltype(less)> firstAt(less);
    std::vector<std::uint32_t> same;
    for (const Vec2& p : points)
      same.push_back(firstAt.try_emplace(p, static_cast<std::uint32_t>(same.size())).first->second);
    return same;
  }

  Triangulation triangulation_;
  std::map<DirectedEdge, int> passages_;
};

}  // namespace

MultiPolygon cover(const std::vector<Ring>& rings, CoverRule rule) {
  return Cover(rings).polygons(rule);
}

}  // namespace lodestone
