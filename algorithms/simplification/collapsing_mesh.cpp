#include "algorithms/simplification/collapsing_mesh.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace lodestone {
namespace {

/// Cosine between the normals of a triangle before and after a collapse that still is no turning over.
constexpr double kFlattest = 1e-3;
/// Share of its area that a triangle must keep in a collapse.
constexpr double kThinnest = 1e-9;
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

}  // namespace

CollapsingMesh::CollapsingMesh(const ComponentMesh& mesh, const CollapseCost& where)
    : where_(where),
      half_(makeHalfEdges(mesh, makeEdges(mesh))),
      triangles_(mesh.triangles),
      textures_(mesh.textureCoordinates),
      triangleLeft_(mesh.triangles.size(), true) {
  if (hasManyCharts(mesh)) surfaces_ = mesh.surfaces;
}

void CollapsingMesh::listNeighbours(std::uint32_t v, std::vector<std::uint32_t>& list) const {
  list.clear();
  for (const std::uint32_t copy : copies(v)) {
    if (!isLeft(copy)) continue;
    for (auto h = half_.mesh.cvoh_begin(handle(copy)); h.is_valid(); ++h) list.push_back(end(*h));
  }
}

bool CollapsingMesh::isOpen(std::uint32_t v) const {
  return std::any_of(copies(v).begin(), copies(v).end(), [&](std::uint32_t copy) {
    return isLeft(copy) && half_.mesh.is_boundary(handle(copy));
  });
}

Vec3 CollapsingMesh::normalOf(std::size_t t) const {
  const auto& [a, b, c] = triangles_[t];
  return (position(b) - position(a)).cross(position(c) - position(a));
}

CollapsingMesh::Handle CollapsingMesh::moveOf(std::uint32_t copy, std::uint32_t to) const {
  for (auto h = half_.mesh.cvoh_begin(handle(copy)); h.is_valid(); ++h) {
    if (end(*h) == to) return *h;
  }
  return Handle();
}

bool CollapsingMesh::changesLook(std::uint32_t v1, std::uint32_t v2) const {
  if (!hasCharts()) return false;
  return std::any_of(copies(v1).begin(), copies(v1).end(), [&](std::uint32_t copy) {
    if (!isLeft(copy)) return false;
    const Handle move = moveOf(copy, v2);
    return move.is_valid() && !keepsLook(move, v1, v2);
  });
}

bool CollapsingMesh::mayCollapse(std::uint32_t v1, std::uint32_t v2, const Vec3& at, bool moves) {
  moves_.clear();
  for (const std::uint32_t copy : copies(v1)) {
    if (!isLeft(copy)) continue;
    const Handle move = moveOf(copy, v2);
    if (!move.is_valid() || !half_.mesh.is_collapse_ok(move) || !keepsShape(move, v1, v2, at)) return false;
    if (std::any_of(moves_.begin(), moves_.end(), [&](Handle other) { return meet(move, other); }))
      return false;
    moves_.push_back(move);
  }
  return !moves_.empty() && (!moves || keepsSurroundings(v1, v2, at));
}

/// The target moves as well: no triangle around it that outlives the collapse turns over.
bool CollapsingMesh::keepsSurroundings(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
  for (const std::uint32_t copy : copies(v2)) {
    if (!isLeft(copy)) continue;
    for (auto f = half_.mesh.cvf_begin(handle(copy)); f.is_valid(); ++f) {
      const auto t = static_cast<std::size_t>(f->idx());
      if (hasCorner(triangles_[t], v1)) continue;
      if (!staysUpright(t, v2, at)) return false;
    }
  }
  return true;
}

/// Whether two moves, each fine by itself, are not one after the other: what went into the vertex that both
/// lead to may be next to what follows, or at a rim.
bool CollapsingMesh::meet(Handle move, Handle other) const {
  return half_.mesh.to_vertex_handle(move) == half_.mesh.to_vertex_handle(other);
}

bool CollapsingMesh::keepsShape(Handle move, std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
  const int left = half_.mesh.face_handle(move).idx();
  const int right = half_.mesh.face_handle(half_.mesh.opposite_halfedge_handle(move)).idx();
  for (auto f = half_.mesh.cvf_begin(half_.mesh.from_vertex_handle(move)); f.is_valid(); ++f) {
    if (f->idx() == left || f->idx() == right) continue;
    const auto t = static_cast<std::size_t>(f->idx());
    if (hasCorner(triangles_[t], v2) || !staysUpright(t, v1, at)) return false;
  }
  return true;
}

/// Whether every triangle that moves finds v2 in its chart, and about where its texture would be there.
bool CollapsingMesh::keepsLook(Handle move, std::uint32_t v1, std::uint32_t v2) const {
  for (auto f = half_.mesh.cvf_begin(half_.mesh.from_vertex_handle(move)); f.is_valid(); ++f) {
    const auto t = static_cast<std::size_t>(f->idx());
    if (hasCorner(triangles_[t], v2)) continue;
    const std::optional<std::size_t> pattern = patternOf(move, t, v1);
    if (!pattern) return false;
    if (textures_.empty()) continue;
    const Vec2f& from = textures_[t][cornerOf(triangles_[t], v1)];
    const Vec2f& to = textures_[*pattern][cornerOf(triangles_[*pattern], v2)];
    if ((extended(t, position(v2)) - to).norm() > kDrawnOut * (to - from).norm() + kTexel) return false;
  }
  return true;
}

/// With its corner at `vertex` moved to `at`.
bool CollapsingMesh::staysUpright(std::size_t t, std::uint32_t vertex, const Vec3& at) const {
  const Vec3 before = normalOf(t);
  if (before == Vec3::Zero()) return true;
  std::array<Vec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = triangles_[t][i] == vertex ? at : position(triangles_[t][i]);
  const Vec3 after = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double along = before.dot(after);
  const double squared = before.squaredNorm();
  const double squaredAfter = after.squaredNorm();
  return along > 0 && along * along > kFlattest * kFlattest * squared * squaredAfter &&
         squaredAfter > kThinnest * kThinnest * squared;
}

/// Whether two triangles at v belong to one chart there: the same material, texture and texture coordinate.
bool CollapsingMesh::sameChart(std::size_t t, int other, std::uint32_t v) const {
  if (other < 0) return false;
  const auto o = static_cast<std::size_t>(other);
  if (surfaces_[t].material != surfaces_[o].material || surfaces_[t].texture != surfaces_[o].texture)
    return false;
  if (textures_.empty()) return true;
  const Vec2f& here = textures_[t][cornerOf(triangles_[t], v)];
  const Vec2f& there = textures_[o][cornerOf(triangles_[o], v)];
  return here == there || (!here.allFinite() && !there.allFinite());
}

void CollapsingMesh::collapse(std::uint32_t v1, std::uint32_t v2) {
  for (const Handle move : moves_) moveCorners(move, v1, v2);
  for (const Handle move : moves_) half_.mesh.collapse(move);
}

/// The corners at v1 take the place, and the texture coordinate in their chart, of v2.
void CollapsingMesh::moveCorners(Handle move, std::uint32_t v1, std::uint32_t v2) {
  const int left = half_.mesh.face_handle(move).idx();
  const int right = half_.mesh.face_handle(half_.mesh.opposite_halfedge_handle(move)).idx();
  for (auto f = half_.mesh.cvf_begin(half_.mesh.from_vertex_handle(move)); f.is_valid(); ++f) {
    if (f->idx() == left || f->idx() == right) continue;
    const auto t = static_cast<std::size_t>(f->idx());
    moved_.push_back({t, cornerOf(triangles_[t], v1),
                      textures_.empty() ? Vec2f::Zero() : coordinateAfter(move, t, v1, v2)});
  }
  for (const auto& [t, corner, coordinate] : moved_) {
    triangles_[t][corner] = v2;
    if (!textures_.empty()) textures_[t][corner] = coordinate;
  }
  moved_.clear();
  for (const int face : {left, right}) {
    if (face < 0) continue;
    triangleLeft_[static_cast<std::size_t>(face)] = false;
    ++removed_;
  }
}

/// That of v2 in the triangle's chart. A chart without v2 goes on over the plane of the largest of its
/// triangles at v1; out of an image that it lies in it does not go.
Vec2f CollapsingMesh::coordinateAfter(Handle move, std::size_t t, std::uint32_t v1, std::uint32_t v2) const {
  if (const auto pattern = patternOf(move, t, v1))
    return textures_[*pattern][cornerOf(triangles_[*pattern], v2)];
  std::size_t largest = t;
  for (auto f = half_.mesh.cvf_begin(half_.mesh.from_vertex_handle(move)); f.is_valid(); ++f) {
    const auto other = static_cast<std::size_t>(f->idx());
    if (sameChart(t, f->idx(), v1) && normalOf(other).squaredNorm() > normalOf(largest).squaredNorm())
      largest = other;
  }
  const Vec2f st = extended(largest, position(v2));
  const auto& corners = textures_[largest];
  const bool inImage = std::all_of(corners.begin(), corners.end(), [](const Vec2f& corner) {
    return corner.minCoeff() >= 0 && corner.maxCoeff() <= 1;
  });
  return inImage ? Vec2f(st.cwiseMax(0).cwiseMin(1)) : st;
}

/// The triangle beside the edge that is of the same chart as triangle t at v.
std::optional<std::size_t> CollapsingMesh::patternOf(Handle move, std::size_t t, std::uint32_t v) const {
  for (const Handle side : {move, half_.mesh.opposite_halfedge_handle(move)}) {
    const int face = half_.mesh.face_handle(side).idx();
    if (sameChart(t, face, v)) return static_cast<std::size_t>(face);
  }
  return std::nullopt;
}

/// The texture coordinate of a triangle at a point of its plane, or at the foot of a point beside it.
Vec2f CollapsingMesh::extended(std::size_t t, const Vec3& at) const {
  const auto& [a, b, c] = triangles_[t];
  const auto& [sa, sb, sc] = textures_[t];
  const Vec3 ab = position(b) - position(a);
  const Vec3 ac = position(c) - position(a);
  const Vec3 normal = ab.cross(ac);
  const double squared = normal.squaredNorm();
  if (squared == 0) return sa;
  const Vec3 to = at - position(a);
  const auto u = static_cast<float>(to.cross(ac).dot(normal) / squared);
  const auto w = static_cast<float>(ab.cross(to).dot(normal) / squared);
  return sa + u * (sb - sa) + w * (sc - sa);
}

void CollapsingMesh::removeAll() {
  triangleLeft_.assign(triangles_.size(), false);
  removed_ = static_cast<std::uint32_t>(triangles_.size());
}

double CollapsingMesh::extent() const {
  double area = 0;
  Box3 box;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (!triangleLeft_[t]) continue;
    area += normalOf(t).norm() / 2;
    for (const std::uint32_t v : triangles_[t]) box.add(position(v));
  }
  return area * box.size().squaredNorm();
}

}  // namespace lodestone
