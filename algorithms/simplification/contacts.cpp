#include "algorithms/simplification/contacts.h"

#include <algorithm>
#include <memory>

#include "algorithms/geometry/mesh_edges.h"
#include "algorithms/geometry/parallel.h"
#include "algorithms/geometry/triangle_tree.h"
#include "algorithms/simplification/classification.h"

namespace lodestone {
namespace {

/// Trees over components of a mesh.
class Forest {
 public:
  /// Plants those of the components that are `wanted`. In parallel.
  Forest(const ComponentMesh& mesh, const std::vector<bool>& wanted, const Progress& progress)
      : mesh_(mesh), edges_(makeEdges(mesh)), trees_(mesh.components.size()) {
    forPieces(0, trees_.size(), 16, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t c = first; c < last; ++c) {
        const Component& component = mesh_.components[c];
        if (wanted[c])
          trees_[c] = std::make_unique<TriangleTree>(mesh_.vertices, mesh_.triangles, component.firstTriangle,
                                                     component.triangleCount);
      }
    });
  }

  [[nodiscard]] bool closed(std::uint32_t c) const { return isClosed(edges_, c); }
  [[nodiscard]] const Vec3& anyVertex(std::uint32_t c) const {
    return mesh_.vertices[mesh_.components[c].firstVertex];
  }
  /// Distance of two components; 0 where they cross or one encloses the other.
  [[nodiscard]] double distance(std::uint32_t a, std::uint32_t b) const {
    const TriangleTree& treeA = *trees_[a];
    const TriangleTree& treeB = *trees_[b];
    const double apart = treeA.distance(treeB);
    if (apart == 0) return 0;
    const bool enclosed =
        (closed(a) && treeA.encloses(anyVertex(b))) || (closed(b) && treeB.encloses(anyVertex(a)));
    return enclosed ? 0 : apart;
  }

 private:
  const ComponentMesh& mesh_;
  MeshEdges edges_;
  std::vector<std::unique_ptr<TriangleTree>> trees_;
};

/// By contact: the middle of the ends that lie inside.
std::vector<Vec3> places(const ComponentMesh& mesh, const Classification& classes) {
  std::vector<Vec3> sums(classes.contacts.size(), Vec3::Zero());
  std::vector<double> counts(classes.contacts.size(), 0);
  for (const BoundaryEdge& edge : classes.edges) {
    const std::uint32_t own = componentOfVertex(mesh, edge.from);
    const std::pair pair(std::min(own, edge.other), std::max(own, edge.other));
    const auto found = std::lower_bound(classes.contacts.begin(), classes.contacts.end(), pair);
    const auto contact = static_cast<std::size_t>(found - classes.contacts.begin());
    for (const auto& [vertex, inside] :
         {std::pair(edge.from, edge.fromInside), std::pair(edge.to, edge.toInside)}) {
      if (!inside) continue;
      sums[contact] += mesh.vertices[vertex];
      ++counts[contact];
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (counts[i] > 0) sums[i] /= counts[i];
  }
  return sums;
}

}  // namespace

std::vector<ContactReport> followContacts(const ComponentMesh& original, const Classification& classes,
                                          const Simplified& simplified, const Progress& progress) {
  constexpr std::uint32_t kGone = 0xFFFFFFFFU;
  std::vector<std::uint32_t> now(original.components.size(), kGone);
  for (std::uint32_t c = 0; c < simplified.component.size(); ++c) now[simplified.component[c]] = c;
  const double noise = kContactNoise * bounds(original).size().norm();
  std::vector<bool> touching(original.components.size(), false);
  std::vector<bool> touchingNow(simplified.mesh.components.size(), false);
  for (const auto& [a, b] : classes.contacts) {
    for (const std::uint32_t c : {a, b}) {
      touching[c] = true;
      if (now[c] != kGone) touchingNow[now[c]] = true;
    }
  }
  const Forest before(original, touching, progress);
  const Forest after(simplified.mesh, touchingNow, progress);
  progress.checkpoint();
  const std::vector<Vec3> at = places(original, classes);
  std::vector<ContactReport> reports(classes.contacts.size());
  forPiecesReported(reports.size(), 8, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto [a, b] = classes.contacts[i];
      reports[i] = {a, b, ContactFate::Lost, 0, at[i]};
      if (now[a] == kGone || now[b] == kGone) continue;
      const double apart = after.distance(now[a], now[b]);
      const bool kept = apart <= noise || apart <= before.distance(a, b) + noise;
      reports[i].fate = kept ? ContactFate::Kept : ContactFate::Separated;
      reports[i].gap = kept ? 0 : apart;
    }
  });
  progress.checkpoint();
  return reports;
}

}  // namespace lodestone
