// The points are divided into tiles by a k-d tree, each tile is triangulated by itself, and what its border
// leaves open is triangulated again with that of the tiles beside it, upwards to the root. A vertex is
// settled when the circles of all its triangles lie inside its tile: nothing outside can then be joined to
// it. An edge of the spanning tree between two tiles therefore joins two open vertices, and since the circle
// over it is empty of all points it is in the triangulation of the open ones too.
#include "algorithms/clustering/spanning_tree.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include "algorithms/geometry/disjoint_sets.h"

namespace lodestone {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct VertexInfo {
  std::uint32_t local = 0;  ///< number among the points triangulated together
  bool open = false;        ///< may have neighbours beyond the tile
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

constexpr std::size_t kTilePoints = 8192;  // some 8 ms of triangulation
constexpr int kLevelsBetween = 4;          // open vertices of 16 tiles are triangulated together
constexpr std::size_t kCheckEvery = 1 << 16;

struct Site {
  Vec2 position;
  std::uint32_t point;
};
using Sites = std::vector<Site>;

/// What is left of a part of the k-d tree: candidates for the spanning tree, and vertices still open.
struct Part {
  std::vector<SpanningEdge> edges;
  Sites open;
};

double squaredLength(const Vec2& a, const Vec2& b) {
  const double dx = a.x() - b.x();
  const double dy = a.y() - b.y();
  return dx * dx + dy * dy;
}

SpanningEdge edgeBetween(const Site& a, const Site& b) {
  return {squaredLength(a.position, b.position), std::min(a.point, b.point), std::max(a.point, b.point)};
}

/// Whether the circle through the triangle's corners surely lies inside the box: computed with doubles, and
/// with a margin that covers their rounding. A wrong "no" costs time alone.
bool circleInside(const Vec2& a, const Vec2& b, const Vec2& c, const Box2& box) {
  const Vec2 u = b - a;
  const Vec2 v = c - a;
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  const double twiceArea = u.x() * v.y() - u.y() * v.x();
  if (!(std::abs(twiceArea) > 1e-9 * (uu + vv))) return false;
  const Vec2 centre = Vec2(v.y() * uu - u.y() * vv, u.x() * vv - v.x() * uu) / (2 * twiceArea);
  const double reach = centre.norm() * (1 + 1e-5) + 1e-9 * (a.cwiseAbs().maxCoeff() + 1);
  const Vec2 middle = a + centre;
  return middle.x() - reach > box.min.x() && middle.x() + reach < box.max.x() &&
         middle.y() - reach > box.min.y() && middle.y() + reach < box.max.y();
}

/// Triangulates sites; of sites at one place the one with the smallest number stands for all, joined to each
/// by an edge.
class Tile {
 public:
  Tile(std::span<const Site> sites, Part& part) : sites_(sites), part_(part) {
    std::vector<std::pair<Kernel::Point_2, VertexInfo>> points;
    points.reserve(sites.size());
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
      points.emplace_back(Kernel::Point_2(sites[i].position.x(), sites[i].position.y()),
                          VertexInfo{i, false});
    }
    triangulation_.insert(points.begin(), points.end());
    joinCoincident();
  }

  /// Appends the sites that may have neighbours outside the box.
  void collectOpen(const Box2& box) {
    if (triangulation_.dimension() < 2) {
      for (const auto& vertex : triangulation_.finite_vertex_handles()) vertex->info().open = true;
    }
    for (const auto& face : triangulation_.all_face_handles()) {
      if (triangulation_.dimension() == 2 && !triangulation_.is_infinite(face) &&
          circleInside(at(face->vertex(0)), at(face->vertex(1)), at(face->vertex(2)), box)) {
        continue;
      }
      for (int i = 0; i <= triangulation_.dimension(); ++i) face->vertex(i)->info().open = true;
    }
    for (const auto& vertex : triangulation_.finite_vertex_handles()) {
      if (vertex->info().open) part_.open.push_back(sites_[vertex->info().local]);
    }
  }

  /// Appends the edges of the spanning tree of these sites: the others cannot be in that of more sites.
  void collectEdges() {
    std::vector<LocalEdge> edges;
    edges.reserve(2 * triangulation_.number_of_vertices());
    for (const auto& edge : triangulation_.finite_edges()) {
      const Delaunay::Face_handle face = edge.first;
      const LocalEdge local =
          between(face->vertex(Delaunay::cw(edge.second)), face->vertex(Delaunay::ccw(edge.second)));
      if (triangulation_.dimension() == 2 &&
          (isLongest(local, face->vertex(edge.second)) ||
           isLongest(local, triangulation_.tds().mirror_vertex(face, edge.second)))) {
        continue;
      }
      edges.push_back(local);
    }
    std::sort(edges.begin(), edges.end(),
              [this](const LocalEdge& a, const LocalEdge& b) { return isShorter(a, b); });
    DisjointSets sets(sites_.size());
    for (const LocalEdge& edge : edges) {
      if (sets.join(edge.a, edge.b)) part_.edges.push_back(edgeBetween(sites_[edge.a], sites_[edge.b]));
    }
  }

 private:
  struct LocalEdge {
    double squared = 0;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
  };

  [[nodiscard]] LocalEdge between(Delaunay::Vertex_handle a, Delaunay::Vertex_handle b) const {
    return {squaredLength(at(a), at(b)), a->info().local, b->info().local};
  }

  /// The order of spanning edges, by the sites' own numbers.
  [[nodiscard]] bool isShorter(const LocalEdge& a, const LocalEdge& b) const {
    if (a.squared != b.squared) return a.squared < b.squared;
    return edgeBetween(sites_[a.a], sites_[a.b]) < edgeBetween(sites_[b.a], sites_[b.b]);
  }

  /// Whether the edge is the longest of the triangle with this corner: the longest of a cycle is in no
  /// spanning tree. Leaves less than half of the edges to be sorted.
  [[nodiscard]] bool isLongest(const LocalEdge& edge, Delaunay::Vertex_handle corner) const {
    if (triangulation_.is_infinite(corner)) return false;
    const std::uint32_t c = corner->info().local;
    const Vec2& position = at(corner);
    return isShorter({squaredLength(sites_[edge.a].position, position), edge.a, c}, edge) &&
           isShorter({squaredLength(sites_[edge.b].position, position), edge.b, c}, edge);
  }

  [[nodiscard]] const Vec2& at(Delaunay::Vertex_handle vertex) const {
    return sites_[vertex->info().local].position;
  }

  void joinCoincident() {
    if (triangulation_.number_of_vertices() == sites_.size()) return;
    std::vector<std::uint32_t> order(sites_.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [this](std::uint32_t i) {
      return std::tuple(sites_[i].position.x(), sites_[i].position.y(), sites_[i].point);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
    std::vector<std::uint32_t> first(sites_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool same = i > 0 && sites_[order[i]].position == sites_[order[i - 1]].position;
      first[order[i]] = same ? first[order[i - 1]] : order[i];
      if (same) part_.edges.push_back(edgeBetween(sites_[first[order[i]]], sites_[order[i]]));
    }
    for (const auto& vertex : triangulation_.finite_vertex_handles())
      vertex->info().local = first[vertex->info().local];
  }

  std::span<const Site> sites_;
  Part& part_;
  Delaunay triangulation_;
};

/// The site at which half of a sample is smaller along the axis, moved so that neither side is empty.
double borderOf(std::span<const Site> sites, int axis, double least) {
  constexpr std::size_t kSample = 255;
  std::vector<double> sample;
  const std::size_t step = std::max<std::size_t>(1, sites.size() / kSample);
  for (std::size_t i = 0; i < sites.size(); i += step) sample.push_back(sites[i].position[axis]);
  std::nth_element(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2),
                   sample.end());
  double border = sample[sample.size() / 2];
  if (border > least) return border;
  border = std::numeric_limits<double>::infinity();
  for (const Site& site : sites) {
    if (site.position[axis] > least) border = std::min(border, site.position[axis]);
  }
  return border;
}

class Divider {
 public:
  Divider(std::size_t total, const Progress& progress) : total_(total), progress_(progress) {}

  /// The part of the k-d tree with these sites; `box` holds them, and none of the others inside it. Sites on
  /// a border go to one side together, so that coincident ones never part.
  Part divide(std::span<Site> sites, const Box2& box, int level) {
    Part part;
    if (progress_.stopRequested()) return part;
    Box2 extent;
    for (const Site& site : sites) extent.add(site.position);
    int axis = 0;
    const double longest = extent.size().maxCoeff(&axis);
    if (sites.size() <= kTilePoints || longest <= 0) {
      triangulate(sites, box, level, part);
      progress_.report(static_cast<double>(done_ += sites.size()) / static_cast<double>(total_));
      return part;
    }
    const double border = borderOf(sites, axis, extent.min[axis]);
    const auto middle = std::partition(sites.begin(), sites.end(),
                                       [&](const Site& site) { return site.position[axis] < border; });
    const auto left = static_cast<std::size_t>(middle - sites.begin());
    Box2 lower = box;
    Box2 upper = box;
    lower.max[axis] = border;
    upper.min[axis] = border;
    Part other;
    tbb::parallel_invoke([&] { part = divide(sites.first(left), lower, level + 1); },
                         [&] { other = divide(sites.subspan(left), upper, level + 1); });
    part.edges.insert(part.edges.end(), other.edges.begin(), other.edges.end());
    part.open.insert(part.open.end(), other.open.begin(), other.open.end());
    if (level % kLevelsBetween == 0 && !progress_.stopRequested()) {
      const Sites open = std::exchange(part.open, {});
      triangulate(open, box, level, part);
    }
    return part;
  }

 private:
  static void triangulate(std::span<const Site> sites, const Box2& box, int level, Part& part) {
    Tile tile(sites, part);
    tile.collectEdges();
    if (level > 0) tile.collectOpen(box);
  }

  std::size_t total_;
  const Progress& progress_;
  std::atomic<std::size_t> done_{0};
};

std::vector<SpanningEdge> kruskal(std::vector<SpanningEdge> edges, std::size_t points,
                                  const Progress& progress) {
  tbb::parallel_sort(edges);
  DisjointSets sets(points);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i % kCheckEvery == 0 && progress.stopRequested()) break;
    if (sets.join(edges[i].a, edges[i].b)) edges[kept++] = edges[i];
  }
  edges.resize(kept);
  return edges;
}

}  // namespace

std::vector<SpanningEdge> spanningTree(std::span<const Vec2> points, const Progress& progress) {
  if (points.size() < 2) return {};
  Sites sites;
  sites.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) sites.push_back({points[i], static_cast<std::uint32_t>(i)});
  Box2 everywhere;
  everywhere.min.setConstant(-std::numeric_limits<double>::infinity());
  everywhere.max.setConstant(std::numeric_limits<double>::infinity());
  Part all = Divider(points.size(), progress).divide(sites, everywhere, 0);
  return kruskal(std::move(all.edges), points.size(), progress);
}

}  // namespace lodestone
