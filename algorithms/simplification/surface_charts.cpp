#include "algorithms/simplification/surface_charts.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace lodestone {
namespace {

/// Share of its length in the texture by which a move may end beside where the texture of a triangle would
/// be.
constexpr float kDrawnOut = 0.5F;
/// The same, at least: about a texel.
constexpr float kTexel = 1e-3F;

/// Whether borders of charts or materials can get in the way of a collapse.
bool hasManyCharts(const ComponentMesh& mesh) {
  const auto differs = [&](const SurfaceInfo& surface) {
    return surface.material != mesh.surfaces.front().material ||
           surface.texture != mesh.surfaces.front().texture;
  };
  return !mesh.textureCoordinates.empty() || std::any_of(mesh.surfaces.begin(), mesh.surfaces.end(), differs);
}

/// Whether `found`, where a corner comes to lie from `from` on, is not where the texture goes on.
bool drawsOut(const Vec2f& wanted, const Vec2f& found, const Vec2f& from) {
  return (wanted - found).norm() > kDrawnOut * (found - from).norm() + kTexel;
}

}  // namespace

bool sameChart(const SurfaceInfo& first, const SurfaceInfo& second, const Vec2f& firstPlace,
               const Vec2f& secondPlace) {
  return first.material == second.material && first.texture == second.texture &&
         (firstPlace == secondPlace || (!firstPlace.allFinite() && !secondPlace.allFinite()));
}

SurfaceCharts::SurfaceCharts(const ComponentMesh& mesh, const HalfEdges& half,
                             const std::vector<ComponentMesh::Triangle>& triangles, const CollapseCost& where)
    : mesh_(half.mesh), triangles_(triangles), where_(where), textures_(mesh.textureCoordinates) {
  if (hasManyCharts(mesh)) surfaces_ = mesh.surfaces;
}

/// Whether two triangles at v belong to one chart there.
bool SurfaceCharts::same(std::size_t t, int other, std::uint32_t v) const {
  if (other < 0) return false;
  const auto o = static_cast<std::size_t>(other);
  if (textures_.empty()) return sameChart(surfaces_[t], surfaces_[o], Vec2f::Zero(), Vec2f::Zero());
  return sameChart(surfaces_[t], surfaces_[o], textures_[t][cornerOf(triangles_[t], v)],
                   textures_[o][cornerOf(triangles_[o], v)]);
}

bool SurfaceCharts::keepLook(Handle move, std::uint32_t v1, std::uint32_t v2) const {
  for (auto f = mesh_.cvf_begin(mesh_.from_vertex_handle(move)); f.is_valid(); ++f) {
    const auto t = static_cast<std::size_t>(f->idx());
    if (hasCorner(triangles_[t], v2)) continue;
    const std::optional<std::size_t> pattern = patternOf(move, t, v1);
    if (!pattern) return false;
    if (textures_.empty()) continue;
    const Vec2f& from = textures_[t][cornerOf(triangles_[t], v1)];
    const Vec2f& to = textures_[*pattern][cornerOf(triangles_[*pattern], v2)];
    if (drawsOut(extended(t, where_.position(v2)), to, from)) return false;
  }
  return true;
}

bool SurfaceCharts::keepLook(Handle move, std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
  return followAt(move, mesh_.from_vertex_handle(move), v1, v2, at) &&
         followAt(move, mesh_.to_vertex_handle(move), v2, v1, at);
}

bool SurfaceCharts::followAt(Handle move, VertexHandle copy, std::uint32_t v, std::uint32_t other,
                             const Vec3& at) const {
  for (auto f = mesh_.cvf_begin(copy); f.is_valid(); ++f) {
    const auto t = static_cast<std::size_t>(f->idx());
    if (hasCorner(triangles_[t], other)) continue;
    const std::optional<std::size_t> pattern = largestPattern(move, t, v);
    if (!pattern) return false;
    if (textures_.empty()) continue;
    const Vec2f& from = textures_[t][cornerOf(triangles_[t], v)];
    if (drawsOut(extended(t, at), extendedInImage(*pattern, at), from)) return false;
  }
  return true;
}

Vec2f SurfaceCharts::coordinateAfter(Handle move, std::size_t t, std::uint32_t v1, std::uint32_t v2) const {
  if (const auto pattern = patternOf(move, t, v1))
    return textures_[*pattern][cornerOf(triangles_[*pattern], v2)];
  return extendedInImage(largestOfChart(mesh_.from_vertex_handle(move), t, v1), where_.position(v2));
}

Vec2f SurfaceCharts::coordinateAt(Handle move, VertexHandle copy, std::size_t t, std::uint32_t v,
                                  const Vec3& at) const {
  const std::optional<std::size_t> pattern =
      move.is_valid() ? largestPattern(move, t, v) : std::optional<std::size_t>();
  return extendedInImage(pattern ? *pattern : largestOfChart(copy, t, v), at);
}

/// The triangles beside the edge; −1 where there is none.
std::array<int, 2> SurfaceCharts::sidesOf(Handle move) const {
  return {mesh_.face_handle(move).idx(), mesh_.face_handle(mesh_.opposite_halfedge_handle(move)).idx()};
}

/// The triangle beside the edge that is of the same chart as triangle t at v.
std::optional<std::size_t> SurfaceCharts::patternOf(Handle move, std::size_t t, std::uint32_t v) const {
  for (const int face : sidesOf(move)) {
    if (same(t, face, v)) return static_cast<std::size_t>(face);
  }
  return std::nullopt;
}

/// The larger one where both are: so that all triangles of a chart take the same.
std::optional<std::size_t> SurfaceCharts::largestPattern(Handle move, std::size_t t, std::uint32_t v) const {
  std::optional<std::size_t> largest;
  for (const int face : sidesOf(move)) {
    if (!same(t, face, v)) continue;
    const auto found = static_cast<std::size_t>(face);
    if (!largest || areaOf(found) > areaOf(*largest)) largest = found;
  }
  return largest;
}

std::size_t SurfaceCharts::largestOfChart(VertexHandle copy, std::size_t t, std::uint32_t v) const {
  std::size_t largest = t;
  for (auto f = mesh_.cvf_begin(copy); f.is_valid(); ++f) {
    const auto other = static_cast<std::size_t>(f->idx());
    if (same(t, f->idx(), v) && areaOf(other) > areaOf(largest)) largest = other;
  }
  return largest;
}

/// The texture coordinate of a triangle at a point of its plane, or at the foot of a point beside it.
Vec2f SurfaceCharts::extended(std::size_t t, const Vec3& at) const {
  const auto& [a, b, c] = triangles_[t];
  const auto& [sa, sb, sc] = textures_[t];
  const Vec3 ab = where_.position(b) - where_.position(a);
  const Vec3 ac = where_.position(c) - where_.position(a);
  const Vec3 normal = ab.cross(ac);
  const double squared = normal.squaredNorm();
  if (squared == 0) return sa;
  const Vec3 to = at - where_.position(a);
  const auto u = static_cast<float>(to.cross(ac).dot(normal) / squared);
  const auto w = static_cast<float>(ab.cross(to).dot(normal) / squared);
  return sa + u * (sb - sa) + w * (sc - sa);
}

Vec2f SurfaceCharts::extendedInImage(std::size_t t, const Vec3& at) const {
  const Vec2f st = extended(t, at);
  const bool inImage = std::all_of(textures_[t].begin(), textures_[t].end(), [](const Vec2f& corner) {
    return corner.minCoeff() >= 0 && corner.maxCoeff() <= 1;
  });
  return inImage ? Vec2f(st.cwiseMax(0).cwiseMin(1)) : st;
}

}  // namespace lodestone
