#include "algorithms/geometry/constrained_triangulation.h"

#include <map>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace lodestone {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct FaceSide {
  int side = -1;  // parity of the rings around the face; −1: not reached yet
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel,
                                                CGAL::Triangulation_face_base_with_info_2<FaceSide, Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
/// Vertex numbers of an edge of the triangulation.
using EdgeKey = std::pair<std::uint32_t, std::uint32_t>;

Kernel::Point_2 toPoint(const Vec2& p) {
  return {p.x(), p.y()};
}
EdgeKey undirected(EdgeKey edge) {
  return edge.first < edge.second ? edge : EdgeKey{edge.second, edge.first};
}

class RingTriangulator {
 public:
  RingTriangulator(std::span<const Vec2> points, std::span<const std::uint32_t> ringStart)
      : points_(points), ringStart_(ringStart) {}

  bool run(std::vector<IndexTriangle>& triangles) {
    insertPoints();
    if (triangulation_.dimension() < 2) return true;
    try {
      insertRings();
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    markSides();
    collect(triangles);
    return true;
  }

 private:
  void insertPoints() {
    handles_.reserve(points_.size());
    FaceHandle hint;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const std::size_t before = triangulation_.number_of_vertices();
      const VertexHandle vertex = triangulation_.insert(toPoint(points_[i]), hint);
      if (triangulation_.number_of_vertices() == before) {
        shared_ = true;
      } else {
        vertex->info() = i;
      }
      handles_.push_back(vertex);
      hint = vertex->face();
    }
  }

  void insertRings() {
    forEachRingEdge([this](std::uint32_t from, std::uint32_t to) {
      if (handles_[from] != handles_[to]) triangulation_.insert_constraint(handles_[from], handles_[to]);
    });
    // Only now are the pieces known into which later points and edges cut the earlier ones.
    forEachRingEdge([this](std::uint32_t from, std::uint32_t to) { recordPieces(from, to); });
  }

  template <class Visit>
  void forEachRingEdge(Visit&& visit) const {
    for (std::size_t r = 0; r + 1 < ringStart_.size(); ++r) {
      for (std::uint32_t i = ringStart_[r]; i < ringStart_[r + 1]; ++i) {
        visit(i, i + 1 < ringStart_[r + 1] ? i + 1 : ringStart_[r]);
      }
    }
  }

  void recordPieces(std::uint32_t from, std::uint32_t to) {
    VertexHandle at = handles_[from];
    const VertexHandle end = handles_[to];
    while (at != end) {
      VertexHandle next;
      FaceHandle face;
      int index = 0;
      if (!triangulation_.includes_edge(at, end, next, face, index)) return;
      const EdgeKey piece{at->info(), next->info()};
      covered_[undirected(piece)] ^= 1;
      if (shared_ && at == handles_[from]) cornerOf_[piece] = from;
      at = next;
    }
  }

  // An edge that two rings share separates nothing, hence the parity instead of CGAL's own mark.
  void markSides() {
    std::vector<FaceHandle> open{triangulation_.infinite_face()};
    open.back()->info().side = 0;
    while (!open.empty()) {
      const FaceHandle face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const FaceHandle other = face->neighbor(i);
        if (other->info().side >= 0) continue;
        other->info().side = face->info().side ^ crossing(face, i);
        open.push_back(other);
      }
    }
  }

  int crossing(FaceHandle face, int i) const {
    const VertexHandle a = face->vertex(Triangulation::cw(i));
    const VertexHandle b = face->vertex(Triangulation::ccw(i));
    if (triangulation_.is_infinite(a) || triangulation_.is_infinite(b)) return 0;
    const auto found = covered_.find(undirected({a->info(), b->info()}));
    return found == covered_.end() ? 0 : found->second;
  }

  void collect(std::vector<IndexTriangle>& triangles) const {
    for (const FaceHandle face : triangulation_.finite_face_handles()) {
      if (face->info().side == 0) continue;
      triangles.push_back({cornerAt(face, 0), cornerAt(face, 1), cornerAt(face, 2)});
    }
  }

  // Turning clockwise about the corner from inside, the first ring edge met is the one that leaves the
  // corner.
  std::uint32_t cornerAt(FaceHandle face, int i) const {
    const VertexHandle vertex = face->vertex(i);
    if (!shared_) return vertex->info();
    const FaceHandle start = face;
    do {
      const int at = face->index(vertex);
      const int across =
          Triangulation::cw(at);  // the edge from `vertex` to the next corner counter-clockwise
      const VertexHandle other = face->vertex(Triangulation::ccw(at));
      if (crossing(face, across) != 0) {
        const auto found = cornerOf_.find({vertex->info(), other->info()});
        return found == cornerOf_.end() ? vertex->info() : found->second;
      }
      face = face->neighbor(across);
    } while (face != start);
    return vertex->info();
  }

  std::span<const Vec2> points_;
  std::span<const std::uint32_t> ringStart_;
  Triangulation triangulation_;
  std::vector<VertexHandle> handles_;
  std::map<EdgeKey, int> covered_;             // parity of the ring edges over each edge
  std::map<EdgeKey, std::uint32_t> cornerOf_;  // ring point at which a directed ring edge starts
  bool shared_ = false;                        // some points share their place
};

}  // namespace

bool constrainedTriangulation(std::span<const Vec2> points, std::span<const std::uint32_t> ringStart,
                              std::vector<IndexTriangle>& triangles) {
  return RingTriangulator(points, ringStart).run(triangles);
}

}  // namespace lodestone
