// One component while its edges collapse: what may collapse, and what is left.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/simplification/collapse_cost.h"
#include "algorithms/simplification/half_edges.h"
#include "algorithms/simplification/surface_charts.h"

namespace lodestone {

/// Half-edges for the connectivity, triangles and texture coordinates beside them. A vertex has a half-edge
/// vertex, a copy, for each fan of triangles around it; its copies move together or not at all.
class CollapsingMesh {
 public:
  /// `mesh` has one component. Where its vertices stand is asked of `where`, which outlives this.
  CollapsingMesh(const ComponentMesh& mesh, const CollapseCost& where);
  CollapsingMesh(const CollapsingMesh&) = delete;
  CollapsingMesh& operator=(const CollapsingMesh&) = delete;

  /// Calls visit(vertex) for the vertices that v could move onto: those at edges of one of its copies, since
  /// every copy needs an edge to the same vertex.
  template <class Visit>
  void forEachTarget(std::uint32_t v, const Visit& visit) const {
    for (const std::uint32_t copy : copies(v)) {
      if (!isLeft(copy)) continue;
      for (auto h = half_.mesh.cvoh_begin(handle(copy)); h.is_valid(); ++h) visit(end(*h));
      return;
    }
  }
  [[nodiscard]] bool hasCopies(std::uint32_t v) const { return copies(v).size() > 1; }
  /// The vertices at edges of v, once for each copy of v that has one.
  void listNeighbours(std::uint32_t v, std::vector<std::uint32_t>& list) const;
  /// Calls visit(second, third) for each triangle around v, as its half-edges go round: neighbours agree.
  template <class Visit>
  void forEachTriangle(std::uint32_t v, const Visit& visit) const {
    for (const std::uint32_t copy : copies(v)) {
      if (!isLeft(copy)) continue;
      for (auto h = half_.mesh.cvoh_begin(handle(copy)); h.is_valid(); ++h) {
        if (!half_.mesh.is_boundary(*h)) visit(end(*h), end(half_.mesh.next_halfedge_handle(*h)));
      }
    }
  }

  /// The same for the triangles around v that have another vertex `to` as well. `edge` is between the two.
  template <class Visit>
  void forEachTriangleAtEdge(std::uint32_t v, std::uint32_t to, std::uint32_t edge,
                             const Visit& visit) const {
    if (hasCopies(v) && hasCopies(to)) {
      forEachTriangle(v, [&](std::uint32_t second, std::uint32_t third) {
        if (second == to || third == to) visit(second, third);
      });
      return;
    }
    for (const unsigned side : {0U, 1U}) {
      const Handle h = half_.mesh.halfedge_handle(OpenMesh::EdgeHandle(static_cast<int>(edge)), side);
      if (half_.mesh.is_boundary(h)) continue;
      const std::uint32_t opposite = end(half_.mesh.next_halfedge_handle(h));
      if (end(h) == to)
        visit(to, opposite);
      else
        visit(opposite, to);
    }
  }

  /// Edges as half-edges have them: one that more than two triangles shared is several.
  [[nodiscard]] std::uint32_t edgeCount() const { return static_cast<std::uint32_t>(half_.mesh.n_edges()); }
  [[nodiscard]] bool isEdgeLeft(std::uint32_t e) const {
    return !half_.mesh.status(OpenMesh::EdgeHandle(static_cast<int>(e))).deleted();
  }
  /// The smaller vertex first.
  [[nodiscard]] std::array<std::uint32_t, 2> ends(std::uint32_t e) const {
    const auto h = half_.mesh.halfedge_handle(OpenMesh::EdgeHandle(static_cast<int>(e)), 0);
    const std::uint32_t from = end(half_.mesh.opposite_halfedge_handle(h));
    return {std::min(from, end(h)), std::max(from, end(h))};
  }
  template <class Visit>
  void forEachEdge(std::uint32_t v, const Visit& visit) const {
    for (const std::uint32_t copy : copies(v)) {
      if (!isLeft(copy)) continue;
      for (auto h = half_.mesh.cvoh_begin(handle(copy)); h.is_valid(); ++h)
        visit(static_cast<std::uint32_t>(half_.mesh.edge_handle(*h).idx()));
    }
  }
  /// Whether the triangles around v do not close around it.
  [[nodiscard]] bool isOpen(std::uint32_t v) const;

  /// Whether there are several charts of texture coordinates, textures or materials.
  [[nodiscard]] bool hasCharts() const { return charts_.areMany(); }
  /// Whether v1 going into v2 changes how the surface looks beside its shape: it leaves the border of a
  /// chart, which then takes a part of what another one had and goes on over it with its texture, or it draws
  /// out or folds the texture of its own.
  [[nodiscard]] bool changesLook(std::uint32_t v1, std::uint32_t v2) const;
  /// The same where v2 then stands at `at`.
  [[nodiscard]] bool changesLook(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const;

  /// Whether v1 may go into v2, which then stands at `at`; `moves` says whether v2 does move. The surface
  /// stays a manifold, and no triangle turns over or loses its area.
  [[nodiscard]] bool mayCollapse(std::uint32_t v1, std::uint32_t v2, const Vec3& at, bool moves);
  /// Does what mayCollapse() allowed last, at the same place. Positions are the caller's to change, after
  /// this.
  void collapse(std::uint32_t v1, std::uint32_t v2, const Vec3& at);
  void removeAll();

  [[nodiscard]] const Vec3& position(std::uint32_t v) const { return where_.position(v); }
  [[nodiscard]] std::uint32_t removed() const { return removed_; }
  /// Of what is left: its area · its diagonal², m⁴.
  [[nodiscard]] double extent() const;

  /// As they stand now.
  [[nodiscard]] const std::vector<ComponentMesh::Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] const std::vector<std::array<Vec2f, 3>>& textures() const { return charts_.textures(); }
  [[nodiscard]] bool isTriangleLeft(std::size_t t) const { return triangleLeft_[t]; }

 private:
  using Mesh = HalfEdges::Mesh;
  using Handle = Mesh::HalfedgeHandle;

  [[nodiscard]] std::uint32_t end(Handle h) const { return half_.vertexAt(half_.mesh.to_vertex_handle(h)); }
  [[nodiscard]] std::span<const std::uint32_t> copies(std::uint32_t v) const {
    return {half_.copies.data() + half_.copyStart[v], half_.copies.data() + half_.copyStart[v + 1]};
  }
  [[nodiscard]] static Mesh::VertexHandle handle(std::uint32_t copy) {
    return Mesh::VertexHandle(static_cast<int>(copy));
  }
  [[nodiscard]] bool isLeft(std::uint32_t copy) const {
    return !half_.mesh.status(handle(copy)).deleted() && !half_.mesh.is_isolated(handle(copy));
  }
  [[nodiscard]] Vec3 normalOf(std::size_t t) const { return where_.areaNormalOf(triangles_[t]); }
  [[nodiscard]] bool keepsSurroundings(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const;
  [[nodiscard]] bool meet(Handle move, Handle other) const;
  [[nodiscard]] Handle moveOf(std::uint32_t copy, std::uint32_t to) const;
  [[nodiscard]] bool keepsShape(Handle move, std::uint32_t v1, std::uint32_t v2, const Vec3& at) const;
  [[nodiscard]] bool staysUpright(std::size_t t, std::uint32_t vertex, const Vec3& at) const;
  void listMoved(Handle move, std::uint32_t v1, std::uint32_t v2, const Vec3& at);
  void listMovedTarget(Mesh::VertexHandle copy, std::uint32_t v1, std::uint32_t v2, const Vec3& at);

  const CollapseCost& where_;
  HalfEdges half_;
  std::vector<ComponentMesh::Triangle> triangles_;
  SurfaceCharts charts_;
  std::vector<bool> triangleLeft_;
  std::uint32_t removed_ = 0;
  // kept between calls for their memory
  std::vector<Handle> moves_;  ///< of the collapse that was last found possible, one a copy
  struct MovedCorner {
    std::size_t triangle = 0;
    std::size_t corner = 0;
    Vec2f coordinate = Vec2f::Zero();
  };
  std::vector<MovedCorner> moved_;
};

}  // namespace lodestone
