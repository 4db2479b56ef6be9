#include "algorithms/simplification/vertex_clustering.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "algorithms/simplification/simplified_mesh.h"
#include "model/tuple_hash.h"

namespace lodestone {
namespace {

constexpr std::uint32_t kMostCells = 1U << 20U;
constexpr std::uint32_t kNearby = 16;

/// Cells as cubes over the box of a model.
class Grid {
 public:
  Grid(const Box3& box, std::uint32_t cells)
      : low_(box.min), most_(cells - 1), perMetre_(cells / std::max(box.size().maxCoeff(), 1e-300)) {}

  [[nodiscard]] std::array<std::uint32_t, 3> cell(const Vec3& p) const {
    std::array<std::uint32_t, 3> result{};
    for (int i = 0; i < 3; ++i) {
      const double at = std::floor((p[i] - low_[i]) * perMetre_);
      result[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(std::clamp(at, 0.0, most_));
    }
    return result;
  }

 private:
  Vec3 low_;
  double most_;
  double perMetre_;
};

struct Cluster {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  std::uint32_t vertex = 0;  ///< nearest to the middle
  double squared = std::numeric_limits<double>::infinity();
};

/// By vertex: the one that stands for it.
std::vector<std::uint32_t> representatives(const ComponentMesh& mesh, const Grid& grid) {
  std::vector<std::uint32_t> clusterOf(mesh.vertexCount());
  std::vector<Cluster> clusters;
  std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, TupleHash> known;
  for (const Component& component : mesh.components) {
    known.clear();
    for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v) {
      const auto next = static_cast<std::uint32_t>(clusters.size());
      clusterOf[v] = known.try_emplace(grid.cell(mesh.vertices[v]), next).first->second;
      if (clusterOf[v] == next) clusters.emplace_back();
      clusters[clusterOf[v]].sum += mesh.vertices[v];
      ++clusters[clusterOf[v]].count;
    }
  }
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    Cluster& cluster = clusters[clusterOf[v]];
    const double squared = (cluster.sum / cluster.count - mesh.vertices[v]).squaredNorm();
    if (squared < cluster.squared) {
      cluster.squared = squared;
      cluster.vertex = v;
    }
  }
  std::vector<std::uint32_t> result(mesh.vertexCount());
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) result[v] = clusters[clusterOf[v]].vertex;
  return result;
}

/// The triangles between representatives, and which of them are left.
struct Clustered {
  std::vector<ComponentMesh::Triangle> triangles;
  std::vector<bool> left;
  std::uint32_t count = 0;
};

Clustered clustered(const ComponentMesh& mesh, std::uint32_t cells) {
  const std::vector<std::uint32_t> to = representatives(mesh, Grid(bounds(mesh), cells));
  Clustered result;
  result.left.assign(mesh.triangles.size(), false);
  std::unordered_set<ComponentMesh::Triangle, TupleHash> known;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const ComponentMesh::Triangle triangle{to[a], to[b], to[c]};
    result.triangles.push_back(triangle);
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    ComponentMesh::Triangle turned = triangle;
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
    result.left[t] = known.insert(turned).second;
    result.count += result.left[t] ? 1 : 0;
  }
  return result;
}

}  // namespace

Simplified clusterVertices(const ComponentMesh& mesh, std::uint32_t cells) {
  const Clustered grid = clustered(mesh, cells);
  Simplified result = keepTriangles(mesh, mesh.vertices, grid.triangles, mesh.textureCoordinates, grid.left);
  result.operations = mesh.vertexCount() - result.mesh.vertexCount();
  return result;
}

Simplified simplifyByClustering(const ComponentMesh& mesh, double rate, const Progress& progress) {
  const double wanted = (1 - rate) * mesh.triangleCount();
  if (mesh.triangles.empty() || wanted >= mesh.triangleCount())
    return keepTriangles(mesh, mesh.vertices, mesh.triangles, mesh.textureCoordinates,
                         std::vector<bool>(mesh.triangles.size(), true));
  std::uint32_t best = 1;
  double miss = std::numeric_limits<double>::infinity();
  const auto leaves = [&](std::uint32_t cells) {
    progress.checkpoint();
    const double count = clustered(mesh, cells).count;
    if (std::abs(count - wanted) < miss) {
      miss = std::abs(count - wanted);
      best = cells;
    }
    return count;
  };
  std::uint32_t low = 1;
  std::uint32_t high = kMostCells;
  (void)leaves(low);
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (leaves(middle) < wanted ? low : high) = middle;
  }
  const std::uint32_t first = low > kNearby ? low - kNearby : 1;
  for (std::uint32_t cells = first; cells <= std::min(high + kNearby, kMostCells); ++cells)
    (void)leaves(cells);
  progress.report(1);
  return clusterVertices(mesh, best);
}

}  // namespace lodestone
