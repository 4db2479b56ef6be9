#include "algorithms/simplification/vertex_clustering.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/part_models.h"

namespace lodestone {
namespace {

using Corners = std::array<Vec3, 3>;

/// Which vertex stands for each, cell by cell.
std::vector<Corners> referenceClusters(const ComponentMesh& mesh, std::uint32_t cells) {
  const Box3 box = bounds(mesh);
  const double size = box.size().maxCoeff() / cells;
  std::vector<Corners> result;
  for (const Component& component : mesh.components) {
    std::map<std::array<int, 3>, std::vector<Vec3>> members;
    const auto cell = [&](const Vec3& p) {
      std::array<int, 3> key{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        key[i] = std::min(static_cast<int>((p[axis] - box.min[axis]) / size), static_cast<int>(cells) - 1);
      }
      return key;
    };
    for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v)
      members[cell(mesh.vertices[v])].push_back(mesh.vertices[v]);
    const auto standsFor = [&](const Vec3& p) {
      const std::vector<Vec3>& all = members[cell(p)];
      Vec3 middle = Vec3::Zero();
      for (const Vec3& member : all) middle += member;
      middle /= static_cast<double>(all.size());
      return *std::min_element(all.begin(), all.end(), [&](const Vec3& a, const Vec3& b) {
        return (a - middle).squaredNorm() < (b - middle).squaredNorm();
      });
    };
    std::vector<Corners> known;
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) {
      Corners corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = standsFor(mesh.vertices[mesh.triangles[t][i]]);
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
      const bool copy = std::any_of(known.begin(), known.end(), [&](const Corners& other) {
        for (std::size_t turn = 0; turn < 3; ++turn) {
          if (other[0] == corners[turn] && other[1] == corners[(turn + 1) % 3] &&
              other[2] == corners[(turn + 2) % 3])
            return true;
        }
        return false;
      });
      if (!copy) known.push_back(corners);
    }
    result.insert(result.end(), known.begin(), known.end());
  }
  return result;
}

const ComponentMesh& twoBlocks() {
  static const ComponentMesh mesh =
      meshOfParts({bumpyBlock(6, {0, 0, 0}, 6, 1), bumpyBlock(5, {5, 0, 0}, 5, 2)});
  return mesh;
}

TEST(VertexClustering, IsThatOfTheSlowReference) {
  for (std::uint32_t cells = 1; cells < 30; ++cells) {
    const ComponentMesh left = clusterVertices(twoBlocks(), cells).mesh;
    std::vector<Corners> corners;
    for (const auto& [a, b, c] : left.triangles)
      corners.push_back({left.vertices[a], left.vertices[b], left.vertices[c]});
    EXPECT_EQ(corners, referenceClusters(twoBlocks(), cells)) << cells;
  }
}

TEST(VertexClustering, ComesAsNearToTheRateAsAnyGrid) {
  const double all = twoBlocks().triangleCount();
  for (const double rate : {0.1, 0.35, 0.5, 0.8, 0.95}) {
    const auto miss = [&](const Simplified& s) {
      return std::abs(s.mesh.triangleCount() - (1 - rate) * all);
    };
    double least = all;
    for (std::uint32_t cells = 1; cells < 200; ++cells)
      least = std::min(least, miss(clusterVertices(twoBlocks(), cells)));
    EXPECT_EQ(miss(simplifyByClustering(twoBlocks(), rate)), least) << rate;
  }
}

TEST(VertexClustering, RemovesNothingAtRateZeroAndAllAtOne) {
  EXPECT_EQ(simplifyByClustering(twoBlocks(), 0).mesh.triangleCount(), twoBlocks().triangleCount());
  EXPECT_EQ(simplifyByClustering(twoBlocks(), 1).mesh.triangleCount(), 0U);
}

}  // namespace
}  // namespace lodestone
