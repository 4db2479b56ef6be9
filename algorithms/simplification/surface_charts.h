// What the surface of a component looks like while its edges collapse: charts of texture coordinates,
// textures and materials (resources/docs/methods.md, 2.3 and 5.4).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/simplification/collapse_cost.h"
#include "algorithms/simplification/half_edges.h"

namespace lodestone {

/// Whether two triangles of one mesh belong to one chart at a vertex that both have: the same material,
/// texture and texture coordinate.
[[nodiscard]] bool sameChart(const SurfaceInfo& first, const SurfaceInfo& second, const Vec2f& firstPlace,
                             const Vec2f& secondPlace);

/// A move is a half-edge: what it starts at goes to its end, which may move as well.
class SurfaceCharts {
 public:
  using Handle = HalfEdges::Mesh::HalfedgeHandle;
  using VertexHandle = HalfEdges::Mesh::VertexHandle;

  /// Of `mesh`, while its triangles become `triangles`, which stand as `where` says; all but `mesh` outlive
  /// this.
  SurfaceCharts(const ComponentMesh& mesh, const HalfEdges& half,
                const std::vector<ComponentMesh::Triangle>& triangles, const CollapseCost& where);

  /// Whether there are several charts of texture coordinates, textures or materials.
  [[nodiscard]] bool areMany() const { return !surfaces_.empty(); }
  /// Whether every triangle that moves finds the end of the move in its chart, and about where its texture
  /// would be there. \pre areMany()
  [[nodiscard]] bool keepLook(Handle move, std::uint32_t v1, std::uint32_t v2) const;
  /// The same where both ends go to `at`.
  [[nodiscard]] bool keepLook(Handle move, std::uint32_t v1, std::uint32_t v2, const Vec3& at) const;

  /// The texture coordinate of triangle t's corner at v1 when that goes to v2. A chart without v2 goes on
  /// over the plane of the largest of its triangles at v1; out of an image that it lies in it does not go.
  [[nodiscard]] Vec2f coordinateAfter(Handle move, std::size_t t, std::uint32_t v1, std::uint32_t v2) const;
  /// The same when its corner v, around `copy`, goes to `at`, by a move or beside one (an invalid handle).
  [[nodiscard]] Vec2f coordinateAt(Handle move, VertexHandle copy, std::size_t t, std::uint32_t v,
                                   const Vec3& at) const;
  void place(std::size_t t, std::size_t corner, const Vec2f& coordinate) {
    textures_[t][corner] = coordinate;
  }

  /// Texture coordinates of the triangles' corners; empty where none has any.
  [[nodiscard]] const std::vector<std::array<Vec2f, 3>>& textures() const { return textures_; }

 private:
  [[nodiscard]] bool same(std::size_t t, int other, std::uint32_t v) const;
  [[nodiscard]] bool followAt(Handle move, VertexHandle copy, std::uint32_t v, std::uint32_t other,
                              const Vec3& at) const;
  [[nodiscard]] std::array<int, 2> sidesOf(Handle move) const;
  [[nodiscard]] std::optional<std::size_t> patternOf(Handle move, std::size_t t, std::uint32_t v) const;
  [[nodiscard]] std::optional<std::size_t> largestPattern(Handle move, std::size_t t, std::uint32_t v) const;
  [[nodiscard]] std::size_t largestOfChart(VertexHandle copy, std::size_t t, std::uint32_t v) const;
  [[nodiscard]] Vec2f extended(std::size_t t, const Vec3& at) const;
  [[nodiscard]] Vec2f extendedInImage(std::size_t t, const Vec3& at) const;
  [[nodiscard]] double areaOf(std::size_t t) const {
    return where_.areaNormalOf(triangles_[t]).squaredNorm();
  }

  const HalfEdges::Mesh& mesh_;
  const std::vector<ComponentMesh::Triangle>& triangles_;
  const CollapseCost& where_;
  std::vector<SurfaceInfo> surfaces_;  ///< empty where no border of a chart or material is in the way
  std::vector<std::array<Vec2f, 3>> textures_;
};

}  // namespace lodestone
