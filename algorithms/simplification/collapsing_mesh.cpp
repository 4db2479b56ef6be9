#include "algorithms/simplification/collapsing_mesh.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace lodestone {
namespace {

/// Cosine between the normals of a triangle before and after a collapse that still is no turning over.
constexpr double kFlattest = 1e-3;
/// Share of its area that a triangle must keep in a collapse.
constexpr double kThinnest = 1e-9;

}  // namespace

CollapsingMesh::CollapsingMesh(const ComponentMesh& mesh, const CollapseCost& where)
    : where_(where),
      half_(makeHalfEdges(mesh, makeEdges(mesh))),
      triangles_(mesh.triangles),
      charts_(mesh, half_, triangles_, where),
      triangleLeft_(mesh.triangles.size(), true) {}

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
    return move.is_valid() && !charts_.keepLook(move, v1, v2);
  });
}

bool CollapsingMesh::changesLook(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
  if (!hasCharts()) return false;
  if (at == position(v2)) return changesLook(v1, v2);
  if (hasCopies(v2)) return true;  // fans of v2 away from the edge have nothing to go by
  return std::any_of(copies(v1).begin(), copies(v1).end(), [&](std::uint32_t copy) {
    if (!isLeft(copy)) return false;
    const Handle move = moveOf(copy, v2);
    return move.is_valid() && !charts_.keepLook(move, v1, v2, at);
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

void CollapsingMesh::collapse(std::uint32_t v1, std::uint32_t v2, const Vec3& at) {
  moved_.clear();
  for (const Handle move : moves_) listMoved(move, v1, v2, at);
  if (!textures().empty() && at != position(v2)) {
    for (const std::uint32_t copy : copies(v2)) {
      if (isLeft(copy)) listMovedTarget(handle(copy), v1, v2, at);
    }
  }
  for (const auto& [t, corner, coordinate] : moved_) {
    triangles_[t][corner] = v2;
    if (!textures().empty()) charts_.place(t, corner, coordinate);
  }
  for (const Handle move : moves_) {
    for (const Handle side : {move, half_.mesh.opposite_halfedge_handle(move)}) {
      const int face = half_.mesh.face_handle(side).idx();
      if (face < 0) continue;
      triangleLeft_[static_cast<std::size_t>(face)] = false;
      ++removed_;
    }
  }
  for (const Handle move : moves_) half_.mesh.collapse(move);
}

/// The corners at v1 take the place, and the texture coordinate in their chart, of v2 or of where it goes.
void CollapsingMesh::listMoved(Handle move, std::uint32_t v1, std::uint32_t v2, const Vec3& at) {
  const Mesh::VertexHandle copy = half_.mesh.from_vertex_handle(move);
  const int left = half_.mesh.face_handle(move).idx();
  const int right = half_.mesh.face_handle(half_.mesh.opposite_halfedge_handle(move)).idx();
  for (auto f = half_.mesh.cvf_begin(copy); f.is_valid(); ++f) {
    if (f->idx() == left || f->idx() == right) continue;
    const auto t = static_cast<std::size_t>(f->idx());
    Vec2f coordinate = Vec2f::Zero();
    if (!textures().empty())
      coordinate = at == position(v2) ? charts_.coordinateAfter(move, t, v1, v2)
                                      : charts_.coordinateAt(move, copy, t, v1, at);
    moved_.push_back({t, cornerOf(triangles_[t], v1), coordinate});
  }
}

/// Those at v2 when it goes somewhere itself.
void CollapsingMesh::listMovedTarget(Mesh::VertexHandle copy, std::uint32_t v1, std::uint32_t v2,
                                     const Vec3& at) {
  const auto leadsHere = [&](Handle move) { return half_.mesh.to_vertex_handle(move) == copy; };
  const auto found = std::find_if(moves_.begin(), moves_.end(), leadsHere);
  const Handle move = found == moves_.end() ? Handle() : *found;
  for (auto f = half_.mesh.cvf_begin(copy); f.is_valid(); ++f) {
    const auto t = static_cast<std::size_t>(f->idx());
    if (hasCorner(triangles_[t], v1)) continue;
    moved_.push_back({t, cornerOf(triangles_[t], v2), charts_.coordinateAt(move, copy, t, v2, at)});
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
