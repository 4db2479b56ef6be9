#include "algorithms/collapsing_mesh.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace lodestone {
namespace {

/// Cosine between the normals of a triangle before and after a collapse that still is no turning over.
constexpr double kFlattest = 1e-3;
/// Share of its area that a triangle must keep in a collapse.
constexpr double kThinnest = 1e-9;

/// Whether borders of charts or materials can get in the way of a collapse.
bool hasManyCharts(const ComponentMesh& mesh) {
  const auto differs = [&](const SurfaceInfo& surface) {
    return surface.material != mesh.surfaces.front().material ||
           surface.texture != mesh.surfaces.front().texture;
  };
  return !mesh.textureCoordinates.empty() || std::any_of(mesh.surfaces.begin(), mesh.surfaces.end(), differs);
}

bool hasCorner(const ComponentMesh::Triangle& triangle, std::uint32_t v) {
  return std::find(triangle.begin(), triangle.end(), v) != triangle.end();
}

std::size_t cornerOf(const ComponentMesh::Triangle& triangle, std::uint32_t v) {
  return triangle[0] == v ? 0 : triangle[1] == v ? 1 : 2;
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

bool CollapsingMesh::mayCollapse(std::uint32_t v1, std::uint32_t v2, const Vec3& at, bool moves) {
  moves_.clear();
  for (const std::uint32_t copy : copies(v1)) {
    if (!isLeft(copy)) continue;
    Handle move;
    for (auto h = half_.mesh.cvoh_begin(handle(copy)); h.is_valid() && !move.is_valid(); ++h) {
      if (end(*h) == v2) move = *h;
    }
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
    if (!surfaces_.empty() && !sameChart(t, left, v1) && !sameChart(t, right, v1)) return false;
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
    const std::size_t corner = cornerOf(triangles_[t], v1);
    if (!textures_.empty()) {
      const auto pattern = static_cast<std::size_t>(sameChart(t, left, v1) ? left : right);
      textures_[t][corner] = textures_[pattern][cornerOf(triangles_[pattern], v2)];
    }
    moved_.emplace_back(t, corner);
  }
  for (const auto& [t, corner] : moved_) triangles_[t][corner] = v2;
  moved_.clear();
  for (const int face : {left, right}) {
    if (face < 0) continue;
    triangleLeft_[static_cast<std::size_t>(face)] = false;
    ++removed_;
  }
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
