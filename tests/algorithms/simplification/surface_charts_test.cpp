// Textures and materials where edges contract to places of their own.
#include "algorithms/simplification/surface_charts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "algorithms/simplification/simplification.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

/// Where charts lie in the texture: an affine map of space for each.
Vec2f placeOf(const Vec3& p, int chart) {
  const auto c = static_cast<float>(chart);
  return Vec2f(static_cast<float>(p.x()) * 0.7F + static_cast<float>(p.y()) * 0.2F + 5 * c,
               static_cast<float>(p.y()) * 0.9F - static_cast<float>(p.x()) * 0.1F * c + 3 * c);
}

template <class ChartOf>
void textureCharts(ComponentMesh& mesh, const ChartOf& chartOf) {
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    std::array<Vec2f, 3> st;
    for (std::size_t i = 0; i < 3; ++i) st[i] = placeOf(mesh.vertices[mesh.triangles[t][i]], chartOf(t));
    mesh.textureCoordinates.push_back(st);
    mesh.surfaces[t].texture = 0;
    mesh.surfaces[t].material = chartOf(t);
  }
}

/// A sheet with bumps of some height; chart i over the i-th share of its length.
ComponentMesh sheet(int n, int charts, double height) {
  Faces faces;
  std::vector<int> chartOf;
  const auto at = [&](int x, int y) {
    return Vec3(x, y, height * std::sin(1.3 * x + 0.7 * y) * std::cos(0.9 * y));
  };
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
      chartOf.insert(chartOf.end(), 2, x * charts / n);
    }
  }
  ComponentMesh mesh = meshOfParts({faces});
  textureCharts(mesh, [&](std::uint32_t t) { return chartOf[t]; });
  return mesh;
}

/// How far a corner lies in the texture from where its chart is at its place, at most.
float worstPlace(const ComponentMesh& mesh) {
  float worst = 0;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2f expected = placeOf(mesh.vertices[mesh.triangles[t][i]], mesh.surfaces[t].material);
      worst = std::max(worst, (mesh.textureCoordinates[t][i] - expected).norm());
    }
  }
  return worst;
}

std::map<int, double> areas(const ComponentMesh& mesh) {
  std::map<int, double> area;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t)
    area[mesh.surfaces[t].material] += areaNormal(mesh, t).norm() / 2;
  return area;
}

TEST(SurfaceCharts, KeepTheirPlacesAndBordersInAPlane) {
  const ComponentMesh mesh = sheet(12, 3, 0);
  const Simplified simplified = simplify(mesh, {.method = SimplifyMethod::Perception, .rate = 0.85});
  EXPECT_LE(simplified.mesh.triangleCount(), 44U);
  EXPECT_LT(worstPlace(simplified.mesh), 1e-3F);
  const auto before = areas(mesh);
  for (const auto& [chart, area] : areas(simplified.mesh)) EXPECT_NEAR(area, before.at(chart), 1e-6);
}

/// Vertices go to places that no vertex had, and their texture goes with them.
TEST(SurfaceCharts, GoOnToWhereAVertexMoves) {
  for (const SimplifyMethod method : {SimplifyMethod::Perception, SimplifyMethod::QemOptimal}) {
    const ComponentMesh mesh = sheet(12, 2, 0.05);
    const Simplified simplified = simplify(mesh, {.method = method, .rate = 0.3, .rimPlanes = true});
    const auto moved =
        std::count_if(simplified.mesh.vertices.begin(), simplified.mesh.vertices.end(), [&](const Vec3& p) {
          return std::find(mesh.vertices.begin(), mesh.vertices.end(), p) == mesh.vertices.end();
        });
    EXPECT_GT(moved, 10);
    EXPECT_LT(worstPlace(simplified.mesh), method == SimplifyMethod::Perception ? 0.05F : 0.4F);
  }
}

/// A block of which every quad is a chart, so that every vertex is a corner of three or more.
TEST(SurfaceCharts, HoldWhatWouldDrawOneOverAnotherAndThatIsCounted) {
  ComponentMesh mesh = meshOfParts({bumpyBlock(3, {0, 0, 0}, 3, 7)});
  EXPECT_EQ(simplify(mesh, {.method = SimplifyMethod::Perception, .rate = 0.5}).heldByCharts, 0U);
  textureCharts(mesh, [](std::uint32_t t) { return static_cast<int>(t / 2); });
  const Simplified simplified = simplify(mesh, {.method = SimplifyMethod::Perception, .rate = 0.5});
  EXPECT_EQ(simplified.mesh.triangles, mesh.triangles);
  EXPECT_EQ(simplified.mesh.textureCoordinates, mesh.textureCoordinates);
  EXPECT_GT(simplified.heldByCharts, mesh.triangleCount());  // of 3 edges for 2 triangles
  const auto leftWithin = [&](double error) {
    return simplify(mesh, {.method = SimplifyMethod::Perception, .rate = 0.5, .error = error})
        .mesh.triangleCount();
  };
  EXPECT_EQ(leftWithin(0.3), mesh.triangleCount());  // all edges are longer
  EXPECT_LT(leftWithin(1.2), mesh.triangleCount());
}

/// Materials alone, on a sheet whose border between them has a corner.
TEST(SurfaceCharts, OfMaterialsKeepTheCornersOfTheirBorders) {
  ComponentMesh mesh = sheet(8, 1, 0);
  mesh.textureCoordinates.clear();
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Vec3 middle = (mesh.vertices[mesh.triangles[t][0]] + mesh.vertices[mesh.triangles[t][1]] +
                         mesh.vertices[mesh.triangles[t][2]]) /
                        3;
    mesh.surfaces[t].material = middle.x() < 4 && middle.y() < 4 ? 1 : 0;
  }
  const auto before = areas(mesh);
  const Simplified simplified = simplify(mesh, {.method = SimplifyMethod::Perception, .rate = 0.9});
  EXPECT_LE(simplified.mesh.triangleCount(), 13U);
  for (const auto& [material, area] : areas(simplified.mesh)) EXPECT_NEAR(area, before.at(material), 1e-6);
}

}  // namespace
}  // namespace lodestone
