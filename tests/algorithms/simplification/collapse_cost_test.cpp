// What a collapse costs, restated from the paper's equations, triangle by triangle.
#include "algorithms/simplification/collapse_cost.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "algorithms/geometry/components.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/simplification.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

using Triangle = ComponentMesh::Triangle;

std::vector<Triangle> around(const std::vector<Triangle>& triangles, std::uint32_t v) {
  std::vector<Triangle> found;
  for (const Triangle& t : triangles) {
    if (std::count(t.begin(), t.end(), v) > 0) found.push_back(t);
  }
  return found;
}

Vec3 areaNormalOf(const ComponentMesh& mesh, const Triangle& t) {
  return (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
}

/// Eq. (1): Q of v1 at v2, where that of v2 is 0.
double qem(const ComponentMesh& mesh, const std::vector<Triangle>& triangles, std::uint32_t v1,
           std::uint32_t v2) {
  double sum = 0;
  for (const Triangle& t : around(triangles, v1)) {
    const Vec3 normal = areaNormalOf(mesh, t);
    const double distance = normal.normalized().dot(mesh.vertices[v2] - mesh.vertices[v1]);
    sum += normal.norm() / 2 * distance * distance;
  }
  return sum;
}

double qemStar(const ComponentMesh& mesh, const std::vector<Triangle>& triangles, std::uint32_t v1,
               std::uint32_t v2) {
  double area = 0;
  for (const Triangle& t : around(triangles, v1)) area += areaNormalOf(mesh, t).norm() / 2;
  return area * (mesh.vertices[v2] - mesh.vertices[v1]).squaredNorm();
}

std::set<std::uint32_t> componentsAt(const ComponentMesh& mesh, const Classification& classes,
                                     std::uint32_t v) {
  std::set<std::uint32_t> found;
  for (std::uint32_t i = classes.planeStart[v]; i < classes.planeStart[v + 1]; ++i)
    found.insert(componentOfTriangle(mesh, classes.planes[i]));
  return found;
}

/// The greatest 1 / |cos θ| of the reference planes of v1; 1 for those of components that v2 lies in as well.
double steepest(const ComponentMesh& mesh, const Classification& classes, std::uint32_t v1,
                std::uint32_t v2) {
  const Vec3 along = (mesh.vertices[v2] - mesh.vertices[v1]).normalized();
  const std::set<std::uint32_t> both = componentsAt(mesh, classes, v2);
  double greatest = 1;
  for (std::uint32_t i = classes.planeStart[v1]; i < classes.planeStart[v1 + 1]; ++i) {
    const std::uint32_t plane = classes.planes[i];
    if (both.count(componentOfTriangle(mesh, plane)) > 0) continue;
    const double sine = std::abs(areaNormal(mesh, plane).normalized().dot(along));
    greatest = std::max(greatest, 1 / std::sqrt(std::max(1 - sine * sine, 1e-30)));
  }
  return greatest;
}

/// Two blocks sunk into each other and an open plate that pierces both.
ComponentMesh blocksAndPlate(unsigned seed) {
  Faces plate;
  for (int x = -2; x < 8; ++x) {
    plate.push_back({Vec3(x, 1.3, 1.1), Vec3(x + 1, 1.4, 1.2), Vec3(x + 1, 2.9, 1.6)});
    plate.push_back({Vec3(x, 1.3, 1.1), Vec3(x + 1, 2.9, 1.6), Vec3(x, 2.8, 1.5)});
  }
  return meshOfParts({bumpyBlock(3, {0, 0, 0}, 4, seed), bumpyBlock(3, {2.7, 0.4, 0.3}, 3, seed + 1), plate});
}

TEST(CollapseCost, IsWhatThePapersEquationsSay) {
  std::array<int, 3> asked{};
  for (unsigned seed = 1; seed < 9; ++seed) {
    const ComponentMesh mesh = blocksAndPlate(seed);
    const Classification classes = classify(mesh);
    std::vector<Triangle> withFill = mesh.triangles;  // which counts where classes do
    withFill.insert(withFill.end(), classes.fill.begin(), classes.fill.end());
    const double a = 1.5 * seed;
    const CollapseCost cost(mesh, &classes, {.a = a});
    const CollapseCost plain(mesh, nullptr, {});
    for (std::uint32_t v1 = 0; v1 < mesh.vertexCount(); ++v1) {
      for (const Triangle& t : around(mesh.triangles, v1)) {
        for (const std::uint32_t v2 : t) {
          if (v2 == v1) continue;
          const double base = qem(mesh, withFill, v1, v2);
          const VertexClass kind = classes.vertices[v1];
          const double expected = kind == VertexClass::Hole       ? qemStar(mesh, withFill, v1, v2)
                                  : kind == VertexClass::Boundary ? a * steepest(mesh, classes, v1, v2) * base
                                                                  : base;
          ++asked[static_cast<std::size_t>(kind)];
          EXPECT_NEAR(plain(v1, v2, false), qem(mesh, mesh.triangles, v1, v2), 1e-9 * (1 + base));
          if (kind == VertexClass::Boundary && steepest(mesh, classes, v1, v2) > 1e3) continue;
          EXPECT_NEAR(cost(v1, v2, false), expected, 1e-6 * (1 + expected)) << v1 << " -> " << v2;
        }
      }
    }
  }
  for (const int count : asked) EXPECT_GT(count, 50);
}

/// A plate of n × n quads.
ComponentMesh plate(int n) {
  Faces faces;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      faces.push_back({Vec3(x, y, 0), Vec3(x + 1, y, 0), Vec3(x + 1, y + 1, 0)});
      faces.push_back({Vec3(x, y, 0), Vec3(x + 1, y + 1, 0), Vec3(x, y + 1, 0)});
    }
  }
  return meshOfParts({faces});
}

TEST(RimPlanes, LetAStraightRimGoAndHoldItsCorners) {
  const ComponentMesh mesh = plate(4);
  const Classification classes = classify(mesh);
  const CollapseCost held(mesh, &classes, {.rimPlanes = true});
  const CollapseCost byLength(mesh, &classes, {});
  const std::uint32_t corner = vertexAt(mesh, 0, {0, 0, 0});
  const std::uint32_t middle = vertexAt(mesh, 0, {1, 0, 0});
  const std::uint32_t next = vertexAt(mesh, 0, {2, 0, 0});
  EXPECT_NEAR(held(middle, next, true), 0, 1e-12);
  EXPECT_NEAR(held(corner, middle, true), 1, 1e-12);  // a metre off the plane over an edge of a metre
  EXPECT_NEAR(byLength(middle, next, true), 1.5, 1e-12);
}

TEST(RimPlanes, KeepTheAreaOfAPlateThatPlainQemEats) {
  const ComponentMesh mesh = plate(10);
  const auto areaLeft = [&](SimplifyMethod method, bool rimPlanes) {
    const ComponentMesh left = simplify(mesh, {.method = method, .rate = 0.9, .rimPlanes = rimPlanes}).mesh;
    double area = 0;
    for (std::uint32_t t = 0; t < left.triangleCount(); ++t) area += areaNormal(left, t).norm() / 2;
    return area;
  };
  for (const SimplifyMethod method :
       {SimplifyMethod::Topology, SimplifyMethod::Qem, SimplifyMethod::QemOptimal})
    EXPECT_NEAR(areaLeft(method, true), 100, 1e-6);
  EXPECT_LT(areaLeft(SimplifyMethod::Qem, false), 90);
  EXPECT_LT(areaLeft(SimplifyMethod::Topology, false),
            99);  // QEM* holds rims that are subdivided, and pays inside
}

}  // namespace
}  // namespace lodestone
