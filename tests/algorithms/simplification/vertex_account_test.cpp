#include "algorithms/simplification/vertex_account.h"

#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/collapse_cost.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

/// A column that stands through a slab.
ComponentMesh columnThroughSlab() {
  return meshOfParts({boxFaces({0, 0, 0}, {10, 10, 1}), boxFaces({4, 4, -3}, {5, 5, 4})});
}

TEST(VertexAccount, SaysWhyAVertexIsBoundary) {
  const ComponentMesh mesh = columnThroughSlab();
  const Classification classes = classify(mesh);
  const std::uint32_t foot = vertexAt(mesh, 1, {4, 4, -3});
  const VertexAccount account = accountOf(mesh, classes, {}, foot);
  EXPECT_EQ(account.vertexClass, VertexClass::Boundary);
  EXPECT_FALSE(account.onHoleEdge);
  ASSERT_FALSE(account.meetings.empty());
  bool upright = false;
  for (const Meeting& meeting : account.meetings) {
    const BoundaryEdge& edge = classes.edges[meeting.edge];
    EXPECT_TRUE(edge.from == foot || edge.to == foot);
    EXPECT_EQ(edge.other, 0U);
    const Vec3 along = mesh.vertices[edge.to] - mesh.vertices[edge.from];
    if (along.head<2>().norm() > 0) continue;
    upright = true;
    EXPECT_TRUE(edge.passesThrough);
    EXPECT_NEAR(meeting.angle, 90, 1e-9);  // across the slab
  }
  EXPECT_TRUE(upright);
  ASSERT_EQ(account.planes.size(), classes.planeCount(foot));
  for (const std::uint32_t plane : account.planes) EXPECT_EQ(componentOfTriangle(mesh, plane), 0U);
}

TEST(VertexAccount, ListsEveryNeighbourOnceWithItsCostTheCheapestFirst) {
  const ComponentMesh mesh = columnThroughSlab();
  const Classification classes = classify(mesh);
  const SimplifyOptions options;
  const CollapseCost cost(mesh, &classes, options);
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    std::vector<std::uint32_t> neighbours;
    for (const auto& triangle : mesh.triangles) {
      if (std::find(triangle.begin(), triangle.end(), v) == triangle.end()) continue;
      for (const std::uint32_t corner : triangle) {
        if (corner != v) neighbours.push_back(corner);
      }
    }
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    const VertexAccount account = accountOf(mesh, classes, options, v);
    ASSERT_EQ(account.moves.size(), neighbours.size());
    for (std::size_t i = 0; i < account.moves.size(); ++i) {
      const MoveCost& move = account.moves[i];
      EXPECT_TRUE(std::binary_search(neighbours.begin(), neighbours.end(), move.to));
      EXPECT_EQ(move.cost, cost(v, move.to, false));
      EXPECT_NEAR(move.length, (mesh.vertices[move.to] - mesh.vertices[v]).norm(), 1e-12);
      if (i > 0) {
        EXPECT_LE(account.moves[i - 1].cost, move.cost);
      }
    }
  }
}

TEST(VertexAccount, SaysWhatAContractionCostsToTheEyeAndWhatIsHeld) {
  const ComponentMesh mesh = meshOfParts({bumpyBlock(3, {0, 0, 0}, 3, 5), bumpyBlock(2, {5, 0, 0}, 2, 6)});
  Admission admission;
  admission.triangles.assign(mesh.triangleCount(), true);
  const std::uint32_t kept = mesh.components[1].firstTriangle + 3;
  admission.triangles[kept] = false;
  const SimplifyOptions options{.method = SimplifyMethod::Perception};
  const Classification classes = classify(mesh);
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const VertexAccount account = accountOf(mesh, classes, options, v, admission);
    const auto& corners = mesh.triangles[kept];
    const auto isHeld = [&](std::uint32_t vertex) {
      return std::find(corners.begin(), corners.end(), vertex) != corners.end();
    };
    EXPECT_EQ(account.held, isHeld(v));
    ASSERT_GE(account.moves.size(), 3U);
    for (const MoveCost& move : account.moves) {
      ASSERT_EQ(move.perceived.has_value(), !(isHeld(v) && isHeld(move.to)));
      if (!move.perceived)
        EXPECT_EQ(move.cost, CollapseCost::kNever);
      else
        EXPECT_EQ(move.cost, std::max(move.perceived->phi, kLeastPhi) * move.perceived->geometry);
    }
    SimplifyOptions combined = options;
    combined.method = SimplifyMethod::Combined;
    EXPECT_EQ(std::isinf(accountOf(mesh, classes, combined, v, admission).moves.front().cost), isHeld(v));
    SimplifyOptions strict = options;
    strict.error = 1e-9;
    for (const MoveCost& move : accountOf(mesh, classes, strict, v, admission).moves)
      EXPECT_EQ(move.cost, CollapseCost::kNever);
  }
}

TEST(VertexAccount, KnowsOpenRims) {
  // One square, standing alone: all its corners end edges with one triangle.
  const ComponentMesh mesh = meshOfParts({{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}});
  const Classification classes = classify(mesh);
  double area = 0;
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const VertexAccount account = accountOf(mesh, classes, {}, v);
    EXPECT_EQ(account.vertexClass, VertexClass::Hole);
    EXPECT_TRUE(account.onHoleEdge);
    EXPECT_TRUE(account.meetings.empty());
    EXPECT_TRUE(account.planes.empty());
    area += account.area;
  }
  EXPECT_NEAR(area, 3 * 4, 1e-9);  // each triangle at its three corners
}

TEST(VertexAccount, BoundaryAngleIsTheGreatestOfTheMetTriangles) {
  const ComponentMesh mesh = columnThroughSlab();
  const Classification classes = classify(mesh);
  ASSERT_FALSE(classes.edges.empty());
  for (const BoundaryEdge& edge : classes.edges) {
    double greatest = 0;
    for (const std::uint32_t t : edge.triangles) {
      const Vec3 along = (mesh.vertices[edge.to] - mesh.vertices[edge.from]).normalized();
      const double sine = std::abs(along.dot(areaNormal(mesh, t).normalized()));
      greatest = std::max(greatest, std::asin(std::min(sine, 1.0)) * 180 / std::acos(-1.0));
    }
    EXPECT_NEAR(boundaryAngle(mesh, edge), greatest, 1e-6);
  }
}

}  // namespace
}  // namespace lodestone
