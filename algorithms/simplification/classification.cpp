#include "algorithms/simplification/classification.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>
#include <tuple>

#include <Eigen/Geometry>

#include "algorithms/geometry/box_pairs.h"
#include "algorithms/geometry/mesh_edges.h"
#include "algorithms/geometry/parallel.h"
#include "algorithms/geometry/triangle_tree.h"
#include "algorithms/simplification/edge_contact.h"
#include "algorithms/simplification/hole_filling.h"

namespace lodestone {
namespace {

/// Normals of two triangles are parallel when the sine between them is below this.
constexpr double kParallel = 1e-4;

/// "Vertex v is boundary, and triangle t is a reference plane of it."
struct Mark {
  std::uint32_t vertex = 0;
  std::uint32_t triangle = 0;
  auto operator<=>(const Mark&) const = default;
};

/// What the edges of one component met of another.
struct Meeting {
  std::vector<BoundaryEdge> edges;
  std::vector<Mark> marks;
};

/// Whether the other component encloses a vertex, asked once however many edges it has.
enum class Enclosed : std::uint8_t { Unknown, No, Yes };

class Classifier {
 public:
  Classifier(const ComponentMesh& mesh, double gap)
      : mesh_(mesh),
        gap_(gap),
        tolerance_(kContactNoise * bounds(mesh).size().norm()),
        edges_(makeEdges(mesh)),
        turn_(trianglesToTurn(mesh, edges_)) {}

  Classification run(const Progress& progress) {
    measureComponents(progress.part(0, 0.1));
    progress.checkpoint();
    const auto pairs = meetingPairs(boxes_);
    plantTrees(pairs, progress.part(0.1, 0.3));
    progress.checkpoint();
    std::vector<Meeting> meetings(2 * pairs.size());  // a → b, then b → a
    forPiecesReported(meetings.size(), 4, progress.part(0.3, 0.95, "classify: contacts"),
                      [&](std::size_t first, std::size_t last) {
                        for (std::size_t i = first; i < last; ++i) {
                          const auto [a, b] = pairs[i / 2];
                          meetings[i] = i % 2 == 0 ? meet(a, b) : meet(b, a);
                        }
                      });
    progress.checkpoint();
    return collect(pairs, meetings);
  }

 private:
  void measureComponents(const Progress& progress) {
    const std::size_t count = mesh_.components.size();
    boxes_.resize(count);
    reach_.resize(count);
    forPieces(0, count, 64, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t c = first; c < last; ++c) measure(static_cast<std::uint32_t>(c));
    });
  }

  /// Box around the component's lengthened edges.
  void measure(std::uint32_t c) {
    Box3 box = bounds(mesh_, mesh_.components[c]);
    double longest = 0;
    for (std::uint32_t e = edges_.firstEdge[c]; e < edges_.firstEdge[c + 1]; ++e)
      longest = std::max(longest, (end(e, 1) - end(e, 0)).norm());
    reach_[c] = gap_ * longest + tolerance_;
    box.min.array() -= reach_[c];
    box.max.array() += reach_[c];
    boxes_[c] = box;
  }

  void plantTrees(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs,
                  const Progress& progress) {
    std::vector<bool> wanted(mesh_.components.size(), false);
    for (const auto& [a, b] : pairs) wanted[a] = wanted[b] = true;
    trees_.resize(mesh_.components.size());
    closed_.resize(mesh_.components.size(), 0);
    forPieces(0, wanted.size(), 16, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t c = first; c < last; ++c) {
        if (!wanted[c]) continue;
        const Component& component = mesh_.components[c];
        trees_[c] = std::make_unique<TriangleTree>(mesh_.vertices, mesh_.triangles, component.firstTriangle,
                                                   component.triangleCount);
        closed_[c] = isClosed(edges_, static_cast<std::uint32_t>(c)) ? 1 : 0;
      }
    });
  }

  [[nodiscard]] const Vec3& end(std::uint32_t edge, std::size_t i) const {
    return mesh_.vertices[edges_.ends[edge][i]];
  }

  [[nodiscard]] TriangleCorners corners(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return {mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]};
  }

  /// Edges of component a against triangles of component b.
  [[nodiscard]] Meeting meet(std::uint32_t a, std::uint32_t b) const {
    Box3 near = trees_[b]->box();
    near.min.array() -= reach_[a];
    near.max.array() += reach_[a];
    std::vector<std::uint32_t> candidates;
    trees_[a]->forEachIn(near, [&](std::uint32_t triangle) {
      for (const std::uint32_t edge : edges_.ofTriangle[triangle]) candidates.push_back(edge);
    });
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    Meeting meeting;
    std::vector<Enclosed> enclosed(mesh_.components[a].vertexCount, Enclosed::Unknown);
    for (const std::uint32_t edge : candidates) meetEdge(edge, b, enclosed, meeting);
    return meeting;
  }

  void meetEdge(std::uint32_t edge, std::uint32_t other, std::vector<Enclosed>& enclosed,
                Meeting& meeting) const {
    const Vec3& p1 = end(edge, 0);
    const Vec3& p2 = end(edge, 1);
    Box3 box;
    box.add(p1 - gap_ * (p2 - p1));
    box.add(p2 + gap_ * (p2 - p1));
    box.min.array() -= tolerance_;
    box.max.array() += tolerance_;
    BoundaryEdge found{edges_.ends[edge][0], edges_.ends[edge][1]};
    found.other = other;
    EdgeContact all;
    bool normal1 = false;  // by the normals of the triangles that are crossed
    bool normal2 = false;
    trees_[other]->forEachIn(box, [&](std::uint32_t triangle) {
      const EdgeContact contact = edgeContact(p1, p2, corners(triangle), gap_, tolerance_);
      if (!contact.meets) return;
      found.triangles.push_back(triangle);
      all.crosses |= contact.crosses;
      all.touches1 |= contact.touches1;
      all.touches2 |= contact.touches2;
      all.overlaps |= contact.overlaps;
      all.reaches1 |= contact.reaches1;
      all.reaches2 |= contact.reaches2;
      if (contact.crosses) (contact.entersAt1 != turn_[triangle] ? normal1 : normal2) = true;
    });
    if (found.triangles.empty()) return;
    std::sort(found.triangles.begin(), found.triangles.end());
    decide(all, normal1, normal2, enclosed, found);
    mark(edge, found, meeting.marks);
    meeting.edges.push_back(std::move(found));
  }

  /// Which ends are boundary vertices.
  void decide(const EdgeContact& all, bool normal1, bool normal2, std::vector<Enclosed>& enclosed,
              BoundaryEdge& found) const {
    found.fromInside = all.touches1 || all.reaches1;
    found.toInside = all.touches2 || all.reaches2;
    found.rule = all.touches1 || all.touches2 || all.overlaps ? InsideRule::Touch : InsideRule::Lengthened;
    bool inside1 = all.touches1;
    bool inside2 = all.touches2;
    if (all.crosses) {
      const bool solid = closed_[found.other] != 0;
      found.rule = solid ? InsideRule::Solid : InsideRule::Normal;
      // an end on the surface is inside: a ray that starts there may say either
      inside1 = solid ? inside1 || isInside(found.from, found.other, enclosed) : normal1;
      inside2 = solid ? inside2 || isInside(found.to, found.other, enclosed) : normal2;
      // crossed twice from outside to outside, the normals name both ends
      found.passesThrough = solid ? !inside1 && !inside2 : inside1 && inside2;
    } else if (all.overlaps && !inside1 && !inside2) {
      found.passesThrough = true;
    }
    found.fromInside |= inside1 || found.passesThrough;
    found.toInside |= inside2 || found.passesThrough;
  }

  [[nodiscard]] bool isInside(std::uint32_t vertex, std::uint32_t other,
                              std::vector<Enclosed>& enclosed) const {
    Enclosed& known = enclosed[vertex - mesh_.components[componentOfVertex(mesh_, vertex)].firstVertex];
    if (known == Enclosed::Unknown)
      known = trees_[other]->encloses(mesh_.vertices[vertex]) ? Enclosed::Yes : Enclosed::No;
    return known == Enclosed::Yes;
  }

  void mark(std::uint32_t edge, const BoundaryEdge& found, std::vector<Mark>& marks) const {
    const auto add = [&](std::uint32_t vertex) {
      for (const std::uint32_t triangle : found.triangles) marks.push_back({vertex, triangle});
    };
    if (found.fromInside) add(found.from);
    if (found.toInside) add(found.to);
    const auto sides = edges_.trianglesOf(edge);
    if (!found.passesThrough || sides.size() != 2 || !parallel(sides[0], sides[1])) return;
    for (const std::uint32_t side : sides) add(opposite(side, found.from, found.to));  // figure 11: embedded
  }

  [[nodiscard]] bool parallel(std::uint32_t s, std::uint32_t t) const {
    const Vec3 m = areaNormal(mesh_, s);
    const Vec3 n = areaNormal(mesh_, t);
    return m.cross(n).norm() <= kParallel * m.norm() * n.norm();
  }

  [[nodiscard]] std::uint32_t opposite(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) {
      if (vertex != a && vertex != b) return vertex;
    }
    return a;
  }

  [[nodiscard]] Classification collect(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs,
                                       std::vector<Meeting>& meetings) const {
    Classification classes;
    classes.gap = gap_;
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (meetings[2 * i].edges.empty() && meetings[2 * i + 1].edges.empty()) continue;
      classes.contacts.push_back(pairs[i]);
      for (Meeting& meeting : std::span(meetings).subspan(2 * i, 2)) {
        marks.insert(marks.end(), meeting.marks.begin(), meeting.marks.end());
        std::move(meeting.edges.begin(), meeting.edges.end(), std::back_inserter(classes.edges));
      }
    }
    std::sort(classes.edges.begin(), classes.edges.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
      return std::tie(a.from, a.to, a.other) < std::tie(b.from, b.to, b.other);
    });
    std::sort(marks.begin(), marks.end());
    marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
    nameClasses(marks, classes);
    fillHoles(classes);
    return classes;
  }

  void nameClasses(const std::vector<Mark>& marks, Classification& classes) const {
    classes.vertices.assign(mesh_.vertices.size(), VertexClass::Ordinary);
    for (std::uint32_t e = 0; e < edges_.ends.size(); ++e) {
      if (!edges_.isHole(e)) continue;
      for (const std::uint32_t vertex : edges_.ends[e]) classes.vertices[vertex] = VertexClass::Hole;
    }
    classes.planeStart.assign(mesh_.vertices.size() + 1, 0);
    for (const Mark& mark : marks) {
      classes.vertices[mark.vertex] = VertexClass::Boundary;
      ++classes.planeStart[mark.vertex + 1];
      classes.planes.push_back(mark.triangle);
    }
    std::partial_sum(classes.planeStart.begin(), classes.planeStart.end(), classes.planeStart.begin());
  }

  /// Fills the loops that have an edge between two boundary vertices.
  void fillHoles(Classification& classes) const {
    const auto boundary = [&](std::uint32_t vertex) {
      return classes.vertices[vertex] == VertexClass::Boundary;
    };
    for (std::uint32_t c = 0; c < mesh_.components.size(); ++c) {
      for (const HoleLoop& loop : holeLoops(mesh_, edges_, c, turn_)) {
        bool held = false;
        for (std::size_t i = 0; i < loop.size() && !held; ++i)
          held = boundary(loop[i]) && boundary(loop[(i + 1) % loop.size()]);
        if (!held) continue;
        const std::vector<ComponentMesh::Triangle> fill = fillHole(mesh_, loop);
        classes.fill.insert(classes.fill.end(), fill.begin(), fill.end());
      }
    }
  }

  const ComponentMesh& mesh_;
  double gap_;
  double tolerance_;
  MeshEdges edges_;
  std::vector<bool> turn_;
  std::vector<Box3> boxes_;    ///< by component, around its lengthened edges
  std::vector<double> reach_;  ///< by component: the most by which one of its edges is lengthened
  std::vector<std::unique_ptr<TriangleTree>> trees_;
  std::vector<std::uint8_t> closed_;
};

}  // namespace

Classification classify(const ComponentMesh& mesh, double gap, const Progress& progress) {
  Classification classes = Classifier(mesh, gap).run(progress);
  progress.report(1);
  return classes;
}

}  // namespace lodestone
