// What a contraction costs to the eye, restated from the paper's equations, triangle by triangle.
#include "algorithms/simplification/perceptual_cost.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "algorithms/simplification/admission.h"
#include "algorithms/simplification/collapse_cost.h"
#include "algorithms/simplification/collapsing_mesh.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

using Triangle = ComponentMesh::Triangle;

bool holds(const Triangle& t, std::uint32_t v) {
  return t[0] == v || t[1] == v || t[2] == v;
}

/// A mesh as lists, with a vertex or two thought to stand elsewhere.
struct Slow {
  const ComponentMesh& mesh;

  [[nodiscard]] Vec3 areaVector(Triangle t, std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
    const auto p = [&](std::uint32_t v) { return v == v1 || v == v2 ? at : mesh.vertices[v]; };
    return (p(t[1]) - p(t[0])).cross(p(t[2]) - p(t[0])) / 2;
  }

  /// Eq. (4) at a vertex.
  [[nodiscard]] double brightness(std::uint32_t v) const {
    Vec3 sum = Vec3::Zero();
    for (const Triangle& t : mesh.triangles) {
      if (holds(t, v)) sum += areaVector(t, v, v, mesh.vertices[v]);
    }
    return FixedLights().brightness(sum.normalized());
  }

  /// Eq. (4) at what two vertices become.
  [[nodiscard]] double brightnessAfter(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
    Vec3 sum = Vec3::Zero();
    for (const Triangle& t : mesh.triangles) {
      if (holds(t, v1) != holds(t, v2)) sum += areaVector(t, v1, v2, at);
    }
    return FixedLights().brightness(sum.normalized());
  }

  /// v̄ᵀ(Q1 + Q2)v̄, with planes through the open edges across their triangles.
  [[nodiscard]] double qem(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
    double sum = 0;
    const auto add = [&](double weight, const Vec3& normal, const Vec3& point) {
      const double distance = normal.normalized().dot(at - point);
      sum += weight * distance * distance;
    };
    for (const std::uint32_t v : {v1, v2}) {
      for (const Triangle& t : mesh.triangles) {
        if (!holds(t, v)) continue;
        const Vec3 area = areaVector(t, t[0], t[0], mesh.vertices[t[0]]);
        add(area.norm(), area, mesh.vertices[v]);
        for (const std::uint32_t w : t) {
          if (w == v || !isOpen(v, w)) continue;
          const Vec3 along = mesh.vertices[w] - mesh.vertices[v];
          add(along.squaredNorm(), area.cross(along), mesh.vertices[v]);
        }
      }
    }
    return sum;
  }

  [[nodiscard]] bool isOpen(std::uint32_t v, std::uint32_t w) const {
    int count = 0;
    for (const Triangle& t : mesh.triangles) count += holds(t, v) && holds(t, w) ? 1 : 0;
    return count == 1;
  }

  [[nodiscard]] double diagonal(std::uint32_t v1, std::uint32_t v2) const {
    Box3 box;
    for (const Triangle& t : mesh.triangles) {
      if (!holds(t, v1) && !holds(t, v2)) continue;
      for (const std::uint32_t v : t) box.add(mesh.vertices[v]);
    }
    return box.size().norm();
  }
};

void expectAsThePaperSays(const ComponentMesh& mesh) {
  const Slow slow{mesh};
  const SimplifyOptions options{.method = SimplifyMethod::Perception};
  const Vec3 origin(0.3, -0.2, 5);
  const CollapseCost cost(mesh, BoundaryPlanes(), options, origin);
  const CollapsingMesh collapsing(mesh, cost);
  const PerceptualCost look(collapsing, mesh.vertexCount(), origin);
  for (std::uint32_t e = 0; e < collapsing.edgeCount(); ++e) {
    const auto& [v1, v2] = collapsing.ends(e);
    const auto places = cost.contractions(v1, v2);
    ASSERT_GE(places.count, 3U);
    for (std::size_t i = 0; i < places.count; ++i) {
      const auto& [at, qem] = places.places[i];
      if (i > 0) {
        EXPECT_GE(qem, places.places[i - 1].cost);
      }
      EXPECT_NEAR(qem, slow.qem(v1, v2, at), 1e-9 * (1 + qem));
      const double i1 = slow.brightness(v1);
      const double i2 = slow.brightness(v2);
      const double phi = std::abs((i1 + i2) / (i1 * i2) * slow.brightnessAfter(v1, v2, at) - 2);
      const PerceptualTerms terms = look(e, at, qem);
      EXPECT_NEAR(terms.phi, phi, 1e-9);
      EXPECT_NEAR(terms.geometry, slow.qem(v1, v2, at) / slow.diagonal(v1, v2), 1e-9 * (1 + qem));
      EXPECT_NEAR(terms.cost(), std::max(phi, 0.05) * terms.geometry, 1e-9 * (1 + qem));
    }
  }
}

TEST(PerceptualCost, IsWhatThePapersEquationsSay) {
  for (unsigned seed = 1; seed < 5; ++seed) {
    expectAsThePaperSays(meshOfParts({bumpyBlock(3, {1, 2, 3}, 4, seed)}));
    Faces open = bumpyBlock(3, {0, 0, 0}, 2, seed + 10);
    open.resize(open.size() - 7);
    expectAsThePaperSays(meshOfParts({open}));
  }
}

/// Four planks that lie flat: what is contracted inside changes neither shape nor light.
TEST(PerceptualCost, IsNothingInAPlane) {
  Faces plate;
  for (int x = 0; x < 4; ++x)
    plate.push_back({Vec3(x, 0, 0), Vec3(x + 1, 0, 0), Vec3(x + 1, 1, 0), Vec3(x, 1, 0)});
  const ComponentMesh mesh = meshOfParts({plate});
  const CollapseCost cost(mesh, nullptr, {.method = SimplifyMethod::Perception});
  const CollapsingMesh collapsing(mesh, cost);
  const PerceptualCost look(collapsing, mesh.vertexCount(), Vec3::Zero());
  const std::uint32_t from = vertexAt(mesh, 0, {1, 0, 0});
  const std::uint32_t to = vertexAt(mesh, 0, {2, 0, 0});
  const Vec3& at = mesh.vertices[to];
  std::uint32_t edge = 0;
  while (collapsing.ends(edge) != std::array{std::min(from, to), std::max(from, to)}) ++edge;
  const PerceptualTerms terms = look(edge, at, cost.qem(from, to, at));
  EXPECT_NEAR(terms.phi, 0, 1e-12);
  EXPECT_NEAR(terms.cost(), 0, 1e-12);
  EXPECT_NEAR(look(edge, at, 1).cost(), kLeastPhi / std::sqrt(10), 1e-12);  // three planks of one metre
}

}  // namespace
}  // namespace lodestone
