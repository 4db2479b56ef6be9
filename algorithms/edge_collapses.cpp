#include "algorithms/edge_collapses.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "algorithms/collapse_cost.h"
#include "algorithms/half_edges.h"
#include "algorithms/simplified_mesh.h"
#include "algorithms/vertex_queue.h"

namespace lodestone {
namespace {

using Mesh = HalfEdges::Mesh;
using Handle = Mesh::HalfedgeHandle;

/// Normals of a ring are parallel when the sine between them is below this.
constexpr double kParallel = 1e-6;
/// Cosine between the normals of a triangle before and after a collapse that still is no turning over.
constexpr double kFlattest = 1e-3;
/// Share of its area that a triangle must keep in a collapse.
constexpr double kThinnest = 1e-9;

/// Moves a vertex of the mesh onto a neighbour: one half-edge for each copy of the vertex.
struct Collapse {
  std::uint32_t v1 = 0;
  std::uint32_t v2 = 0;
  double cost = CollapseCost::kNever;
  double squared = 0;  ///< length of the edge, m²

  /// Among free moves the shortest distorts least.
  [[nodiscard]] bool before(const Collapse& other) const {
    if (cost != other.cost) return cost < other.cost;
    return squared != other.squared ? squared < other.squared : v2 < other.v2;
  }
};

/// What a vertex in the queue waits for.
struct Waiting {
  Collapse collapse;
  bool cheapest = false;  ///< of all its collapses; otherwise of those that were legal when its turn came
  bool sheet = false;     ///< it lies on a planar sheet
};

/// Whether borders of charts or materials can get in the way of a collapse.
bool hasManyCharts(const ComponentMesh& mesh) {
  const auto differs = [&](const SurfaceInfo& surface) {
    return surface.material != mesh.surfaces.front().material ||
           surface.texture != mesh.surfaces.front().texture;
  };
  return !mesh.textureCoordinates.empty() || std::any_of(mesh.surfaces.begin(), mesh.surfaces.end(), differs);
}

class Collapser {
 public:
  Collapser(const ComponentMesh& mesh, const Classification* classes, const SimplifyOptions& options)
      : mesh_(mesh),
        half_(makeHalfEdges(mesh, makeEdges(mesh))),
        optimal_(options.method == SimplifyMethod::QemOptimal),
        cost_(mesh, classes, options.a),
        triangles_(mesh.triangles),
        textures_(mesh.textureCoordinates),
        queue_(mesh.vertices.size() + mesh.components.size()),
        best_(mesh.vertices.size()),
        waiting_(mesh.components.size(), 0),
        triangleLeft_(mesh.triangles.size(), true),
        manyCharts_(hasManyCharts(mesh)) {
    target_ = std::ceil(options.rate * static_cast<double>(mesh.triangles.size()) - 1e-9);
    for (const Component& component : mesh.components) {
      for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v)
        componentOf_.push_back(static_cast<std::uint32_t>(&component - mesh.components.data()));
    }
  }

  Simplified run(const Progress& progress) {
    for (std::uint32_t v = 0; v < mesh_.vertexCount(); ++v) renew(v);
    for (std::uint32_t c = 0; c < mesh_.components.size(); ++c) {
      if (waiting_[c] == 0) offerRemoval(c);
    }
    std::uint32_t steps = 0;
    while (static_cast<double>(removed_) < target_ && !queue_.empty()) {
      if (++steps % 256 == 0) {
        progress.checkpoint();
        progress.report(static_cast<double>(removed_) / target_);
      }
      const std::uint32_t next = queue_.top();
      if (next >= mesh_.vertexCount())
        removeComponent(next - mesh_.vertexCount());
      else
        tryCollapse(next);
    }
    return result();
  }

 private:
  [[nodiscard]] const Vec3& position(std::uint32_t v) const { return cost_.position(v); }
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

  /// Its cost may be kNever where it is above `most`.
  [[nodiscard]] Collapse collapseOf(std::uint32_t v1, std::uint32_t v2, bool sheet, double most) const {
    const double cost = optimal_ ? cost_.contraction(v1, v2).cost : cost_(v1, v2, sheet, most);
    return {v1, v2, cost, (position(v2) - position(v1)).squaredNorm()};
  }

  /// Calls visit(collapse) for all that v can be moved onto at a cost up to `most`, which may fall meanwhile.
  template <class Visit>
  void forEachCollapse(std::uint32_t v, bool sheet, const double& most, const Visit& visit) const {
    for (const std::uint32_t copy : copies(v)) {
      if (!isLeft(copy)) continue;
      for (auto h = half_.mesh.cvoh_begin(handle(copy)); h.is_valid(); ++h) {
        const Collapse collapse = collapseOf(v, end(*h), sheet, most);
        if (collapse.cost < CollapseCost::kNever) visit(collapse);
      }
      break;  // every copy must have an edge to the same vertex: one of them names all that can be
    }
  }

  [[nodiscard]] bool onSheet(std::uint32_t v) const { return cost_.asksForSheet(v) && onPlanarSheet(v); }

  /// All that v can be moved onto, the cheapest first.
  void listCollapses(std::uint32_t v, std::vector<Collapse>& list) const {
    list.clear();
    forEachCollapse(v, onSheet(v), CollapseCost::kNever,
                    [&](const Collapse& collapse) { list.push_back(collapse); });
    std::sort(list.begin(), list.end(), [](const Collapse& a, const Collapse& b) { return a.before(b); });
  }

  /// Whether the triangles around v lie in one plane and do not close around it.
  [[nodiscard]] bool onPlanarSheet(std::uint32_t v) const {
    const auto open = [&](std::uint32_t copy) {
      return isLeft(copy) && half_.mesh.is_boundary(handle(copy));
    };
    if (std::none_of(copies(v).begin(), copies(v).end(), open)) return false;  // most are not: asked first
    Vec3 first = Vec3::Zero();
    for (const std::uint32_t copy : copies(v)) {
      if (!isLeft(copy)) continue;
      for (auto f = half_.mesh.cvf_begin(handle(copy)); f.is_valid(); ++f) {
        const Vec3 normal = normalOf(static_cast<std::size_t>(f->idx()));
        if (first == Vec3::Zero()) first = normal;
        if (first.cross(normal).norm() > kParallel * first.norm() * normal.norm()) return false;
      }
    }
    return true;
  }

  [[nodiscard]] Vec3 normalOf(std::size_t t) const {
    const auto& [a, b, c] = triangles_[t];
    return (position(b) - position(a)).cross(position(c) - position(a));
  }

  /// Puts v in the queue at its cheapest collapse, legal or not: legality is asked when its turn comes.
  void renew(std::uint32_t v) {
    Waiting found{{}, true, onSheet(v)};
    forEachCollapse(v, found.sheet, found.collapse.cost, [&](const Collapse& collapse) {
      if (found.collapse.cost == CollapseCost::kNever || collapse.before(found.collapse))
        found.collapse = collapse;
    });
    if (found.collapse.cost == CollapseCost::kNever)
      drop(v);
    else
      wait(v, found);
  }

  /// renew() after v1 went into v2, a neighbour of v: the costs of v's other collapses stand.
  void renewBeside(std::uint32_t v, std::uint32_t v1, std::uint32_t v2) {
    const Waiting& known = best_[v];
    const bool stands = queue_.contains(v) && known.cheapest && known.collapse.v2 != v1 &&
                        known.collapse.v2 != v2 && copies(v).size() == 1 && known.sheet == onSheet(v);
    if (!stands) return renew(v);
    const Collapse collapse = collapseOf(v, v2, known.sheet, known.collapse.cost);
    if (collapse.cost < CollapseCost::kNever && collapse.before(known.collapse))
      wait(v, {collapse, true, known.sheet});
  }

  void wait(std::uint32_t v, const Waiting& what) {
    if (!queue_.contains(v)) ++waiting_[componentOf_[v]];
    best_[v] = what;
    queue_.set(v, what.collapse.cost);
  }

  void drop(std::uint32_t v) {
    if (!queue_.contains(v)) return;
    queue_.remove(v);
    --waiting_[componentOf_[v]];
  }

  void tryCollapse(std::uint32_t v) {
    const Waiting& known = best_[v];
    if (known.cheapest && findLegal(known.collapse)) return perform(known.collapse);
    listCollapses(v, list_);
    for (const Collapse& candidate : list_) {
      if (!findLegal(candidate)) continue;
      if (candidate.cost > queue_.cost(v))
        wait(v, {candidate, false, false});
      else
        perform(candidate);
      return;
    }
    const std::uint32_t component = componentOf_[v];
    drop(v);
    if (waiting_[component] == 0) rescan(component);
  }

  /// Fills moves_ with a half-edge for each copy; false when one of them has none or may not be collapsed.
  bool findLegal(const Collapse& collapse) {
    moves_.clear();
    at_ = optimal_ ? cost_.contraction(collapse.v1, collapse.v2).at : position(collapse.v2);
    for (const std::uint32_t copy : copies(collapse.v1)) {
      if (!isLeft(copy)) continue;
      Handle move;
      for (auto h = half_.mesh.cvoh_begin(handle(copy)); h.is_valid() && !move.is_valid(); ++h) {
        if (end(*h) == collapse.v2) move = *h;
      }
      if (!move.is_valid() || !half_.mesh.is_collapse_ok(move) || !keepsShape(move, collapse)) return false;
      moves_.push_back(move);
    }
    return !moves_.empty() && (!optimal_ || keepsSurroundings(collapse));
  }

  /// The target moves as well: no triangle around it that outlives the collapse turns over.
  [[nodiscard]] bool keepsSurroundings(const Collapse& collapse) const {
    for (const std::uint32_t copy : copies(collapse.v2)) {
      if (!isLeft(copy)) continue;
      for (auto f = half_.mesh.cvf_begin(handle(copy)); f.is_valid(); ++f) {
        const auto t = static_cast<std::size_t>(f->idx());
        const auto& corners = triangles_[t];
        if (std::find(corners.begin(), corners.end(), collapse.v1) != corners.end()) continue;
        if (!staysUpright(t, collapse.v2)) return false;
      }
    }
    return true;
  }

  /// No triangle turns over or loses its area, and charts keep their borders.
  [[nodiscard]] bool keepsShape(Handle move, const Collapse& collapse) const {
    const int left = half_.mesh.face_handle(move).idx();
    const int right = half_.mesh.face_handle(half_.mesh.opposite_halfedge_handle(move)).idx();
    for (auto f = half_.mesh.cvf_begin(half_.mesh.from_vertex_handle(move)); f.is_valid(); ++f) {
      if (f->idx() == left || f->idx() == right) continue;
      const auto t = static_cast<std::size_t>(f->idx());
      if (!staysUpright(t, collapse.v1)) return false;
      if (manyCharts_ && !sameChart(t, left, collapse.v1) && !sameChart(t, right, collapse.v1)) return false;
    }
    return true;
  }

  /// With its corner at `vertex` moved to at_.
  [[nodiscard]] bool staysUpright(std::size_t t, std::uint32_t vertex) const {
    const Vec3 before = normalOf(t);
    if (before == Vec3::Zero()) return true;
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = triangles_[t][i] == vertex ? at_ : position(triangles_[t][i]);
    const Vec3 after = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double along = before.dot(after);
    const double squared = before.squaredNorm();
    const double squaredAfter = after.squaredNorm();
    return along > 0 && along * along > kFlattest * kFlattest * squared * squaredAfter &&
           squaredAfter > kThinnest * kThinnest * squared;
  }

  [[nodiscard]] std::size_t cornerOf(std::size_t t, std::uint32_t v) const {
    return triangles_[t][0] == v ? 0 : triangles_[t][1] == v ? 1 : 2;
  }

  /// Whether two triangles at v belong to one chart there: the same material, texture and texture coordinate.
  [[nodiscard]] bool sameChart(std::size_t t, int other, std::uint32_t v) const {
    if (other < 0) return false;
    const auto o = static_cast<std::size_t>(other);
    const SurfaceInfo& s = mesh_.surfaces[t];
    const SurfaceInfo& r = mesh_.surfaces[o];
    if (s.material != r.material || s.texture != r.texture) return false;
    if (textures_.empty()) return true;
    const Vec2f& st = textures_[t][cornerOf(t, v)];
    const Vec2f& or_ = textures_[o][cornerOf(o, v)];
    return st == or_ || (!st.allFinite() && !or_.allFinite());
  }

  void perform(const Collapse collapse) {  // a copy: what it stands in is made anew on the way
    for (const Handle move : moves_) moveCorners(move, collapse);
    for (const Handle move : moves_) half_.mesh.collapse(move);
    cost_.collapsed(collapse.v1, collapse.v2, at_);
    drop(collapse.v1);
    ++operations_;
    renewAround(collapse);
    const std::uint32_t component = componentOf_[collapse.v2];
    if (waiting_[component] == 0) rescan(component);
  }

  /// The corners at v1 take the place, and the texture coordinate in their chart, of v2.
  void moveCorners(Handle move, const Collapse& collapse) {
    const int left = half_.mesh.face_handle(move).idx();
    const int right = half_.mesh.face_handle(half_.mesh.opposite_halfedge_handle(move)).idx();
    for (auto f = half_.mesh.cvf_begin(half_.mesh.from_vertex_handle(move)); f.is_valid(); ++f) {
      if (f->idx() == left || f->idx() == right) continue;
      const auto t = static_cast<std::size_t>(f->idx());
      const std::size_t corner = cornerOf(t, collapse.v1);
      if (!textures_.empty()) {
        const auto pattern = static_cast<std::size_t>(sameChart(t, left, collapse.v1) ? left : right);
        textures_[t][corner] = textures_[pattern][cornerOf(pattern, collapse.v2)];
      }
      moved_.emplace_back(t, corner);
    }
    for (const auto& [t, corner] : moved_) triangles_[t][corner] = collapse.v2;
    moved_.clear();
    for (const int face : {left, right}) {
      if (face < 0) continue;
      triangleLeft_[static_cast<std::size_t>(face)] = false;
      ++removed_;
    }
  }

  void renewAround(const Collapse& collapse) {
    ring_.clear();
    for (const std::uint32_t copy : copies(collapse.v2)) {
      if (!isLeft(copy)) continue;
      for (auto h = half_.mesh.cvoh_begin(handle(copy)); h.is_valid(); ++h) ring_.push_back(end(*h));
    }
    renew(collapse.v2);
    for (const std::uint32_t neighbour : ring_) renewBeside(neighbour, collapse.v1, collapse.v2);
  }

  /// All vertices of the component were found without a legal collapse at their turn; what went on since may
  /// have freed one. When none is, the component itself comes up for removal.
  void rescan(std::uint32_t c) {
    const Component& component = mesh_.components[c];
    for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v) {
      listCollapses(v, list_);
      for (std::size_t i = 0; i < list_.size(); ++i) {
        const Collapse candidate = list_[i];
        if (!findLegal(candidate)) continue;
        wait(v, {candidate, false, false});
        break;
      }
    }
    if (waiting_[c] == 0) offerRemoval(c);
  }

  void offerRemoval(std::uint32_t c) {
    double area = 0;
    Box3 box;
    const Component& component = mesh_.components[c];
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) {
      if (!triangleLeft_[t]) continue;
      area += normalOf(t).norm() / 2;
      for (const std::uint32_t v : triangles_[t]) box.add(position(v));
    }
    queue_.set(mesh_.vertexCount() + c, area * box.size().squaredNorm());
  }

  void removeComponent(std::uint32_t c) {
    queue_.remove(mesh_.vertexCount() + c);
    const Component& component = mesh_.components[c];
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) {
      if (!triangleLeft_[t]) continue;
      triangleLeft_[t] = false;
      ++removed_;
    }
    ++operations_;
  }

  [[nodiscard]] Simplified result() {
    std::vector<Vec3> positions;
    for (std::uint32_t v = 0; v < mesh_.vertexCount(); ++v) positions.push_back(position(v));
    Simplified simplified = keepTriangles(mesh_, positions, triangles_, textures_, triangleLeft_);
    simplified.operations = operations_;
    return simplified;
  }

  const ComponentMesh& mesh_;
  HalfEdges half_;
  bool optimal_;  ///< edges contract to where the quadrics are least
  CollapseCost cost_;
  std::vector<ComponentMesh::Triangle> triangles_;  ///< as they stand now, by vertex of the mesh
  std::vector<std::array<Vec2f, 3>> textures_;
  std::vector<std::uint32_t> componentOf_;  ///< by vertex
  VertexQueue queue_;                       ///< vertices, then components that can only be removed
  std::vector<Waiting> best_;               ///< by vertex in the queue
  std::vector<std::uint32_t> waiting_;      ///< by component: its vertices in the queue
  std::vector<bool> triangleLeft_;
  bool manyCharts_;
  double target_ = 0;
  std::size_t removed_ = 0;
  std::uint32_t operations_ = 0;
  // kept between calls for their memory
  std::vector<Collapse> list_;
  std::vector<Handle> moves_;  ///< of the collapse that was last found legal
  Vec3 at_ = Vec3::Zero();     ///< where it leads
  std::vector<std::uint32_t> ring_;
  std::vector<std::pair<std::size_t, std::size_t>> moved_;
};

}  // namespace

Simplified simplifyByCollapses(const ComponentMesh& mesh, const Classification& classes,
                               const SimplifyOptions& options, const Progress& progress) {
  Collapser collapser(mesh, options.method == SimplifyMethod::Topology ? &classes : nullptr, options);
  Simplified simplified = collapser.run(progress);
  progress.report(1);
  return simplified;
}

}  // namespace lodestone
