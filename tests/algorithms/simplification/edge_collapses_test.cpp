#include "algorithms/simplification/edge_collapses.h"

#include <stop_token>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/half_edges.h"
#include "algorithms/simplification/simplified_mesh.h"
#include "model/io/meshes/mesh_import.h"
#include "tests/support/part_models.h"
#include "tests/support/reference_collapses.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

std::vector<std::array<Vec3, 3>> cornersOf(const ComponentMesh& mesh) {
  std::vector<std::array<Vec3, 3>> corners;
  for (const auto& [a, b, c] : mesh.triangles)
    corners.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  return corners;
}

void expectAsReference(const ComponentMesh& mesh, const SimplifyOptions& options) {
  const Classification classes = classify(mesh);
  const test::ReferenceCollapses reference(
      mesh, options.method == SimplifyMethod::Topology ? &classes : nullptr, options);
  EXPECT_EQ(cornersOf(simplifyByCollapses(mesh, classes, options).mesh), reference.result())
      << toText(fields<SimplifyOptions>().front().get(options)) << " at rate " << options.rate;
}

class CollapsesOfMethod : public testing::TestWithParam<SimplifyMethod> {};

TEST_P(CollapsesOfMethod, AreThoseOfTheSlowReference) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    Faces open = bumpyBlock(3, {2.5, 0.5, 0}, 2, seed + 10);
    open.resize(open.size() - 5);
    const ComponentMesh mesh =
        meshOfParts({bumpyBlock(4, {0, 0, 0}, 3, seed), open, boxFaces({-1, -1, -1}, {6, 4, 0.05})});
    for (const double rate : {0.3, 0.7, 0.97})
      expectAsReference(mesh, {.method = GetParam(), .rate = rate, .a = 3});
  }
}

/// So many components that most steps are gone ahead of the order over all of them.
TEST_P(CollapsesOfMethod, AreThoseOfTheSlowReferenceForManyComponents) {
  std::vector<Faces> parts;
  for (unsigned i = 0; i < 14; ++i)
    parts.push_back(bumpyBlock(2 + static_cast<int>(i % 2), {1.9 * i, 0.1 * i, 0}, 2 + 0.05 * i, i + 50));
  const ComponentMesh mesh = meshOfParts(parts);
  for (const double rate : {0.4, 0.85, 1.0}) expectAsReference(mesh, {.method = GetParam(), .rate = rate});
}

/// Many collapses cost nothing, and ties decide.
TEST_P(CollapsesOfMethod, AreThoseOfTheSlowReferenceOnFlatWalls) {
  Faces plate;
  for (int x = 0; x < 7; ++x) {
    for (int y = 0; y < 7; ++y)
      plate.push_back({Vec3(x, y, 0), Vec3(x + 1, y, 0), Vec3(x + 1, y + 1, 0), Vec3(x, y + 1, 0)});
  }
  const ComponentMesh mesh =
      meshOfParts({plate, boxFaces({1, 1, 0}, {3, 3, 2}), boxFaces({3, 1, 0}, {5, 3, 3})});
  for (const double rate : {0.2, 0.5, 0.9}) expectAsReference(mesh, {.method = GetParam(), .rate = rate});
}

/// The components whose vertices have one fan of triangles each, without textures.
ComponentMesh manifoldPart(const ComponentMesh& mesh) {
  const HalfEdges half = makeHalfEdges(mesh, makeEdges(mesh));
  std::vector<bool> left;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Component& component = mesh.components[componentOfTriangle(mesh, t)];
    left.push_back(half.copyStart[component.endVertex()] - half.copyStart[component.firstVertex] ==
                   component.vertexCount);
  }
  ComponentMesh result = keepTriangles(mesh, mesh.vertices, mesh.triangles, {}, left).mesh;
  result.surfaces.assign(result.triangles.size(), {});
  return result;
}

TEST_P(CollapsesOfMethod, AreThoseOfTheSlowReferenceOnARealBuilding) {
  const auto path = test::sharedData("D_meshes/han_china_0ad/meshes/structural/han_house_a.dae");
  if (path.empty()) GTEST_SKIP() << "no shared data";
  const Result<CityModel> city = readMesh(path, {}, {});
  ASSERT_TRUE(city.ok());
  const std::uint32_t first = 0;
  const ComponentMesh mesh = manifoldPart(makeComponentMesh(*city, {&first, 1}));
  EXPECT_GT(mesh.triangleCount(), 200U);
  expectAsReference(mesh, {.method = GetParam(), .rate = 0.6});
}

INSTANTIATE_TEST_SUITE_P(All, CollapsesOfMethod,
                         testing::Values(SimplifyMethod::Topology, SimplifyMethod::Qem,
                                         SimplifyMethod::QemOptimal));

/// Two tubes of three sides, seen in one corner: twelve triangles without a legal collapse.
Faces knot(const Vec3& at, double size) {
  Faces faces = tubeFaces(at, size);
  for (auto face : tubeFaces(at, size)) {
    for (Vec3& p : face) p = 2 * at - p;
    faces.push_back(face);
  }
  return faces;
}

/// They can only go whole, twelve triangles at a time: more than a waiting collapse is taken for, so that the
/// components go too far ahead.
TEST(Collapses, StopAtTheRateWhereComponentsWentTooFarAhead) {
  std::vector<Faces> knots;
  for (int i = 0; i < 40; ++i) knots.push_back(knot({5.0 * i, 0, 0}, 1 + 0.02 * i));
  const ComponentMesh mesh = meshOfParts(knots);
  ASSERT_EQ(mesh.components.size(), 40U);
  const Simplified simplified = simplifyByCollapses(mesh, {}, {.method = SimplifyMethod::Qem, .rate = 0.5});
  ASSERT_EQ(simplified.component.size(), 20U);
  EXPECT_EQ(simplified.component.front(), 20U);  // the smallest went
  EXPECT_EQ(simplified.operations, 20U);
}

TEST(Collapses, LeaveTheLastComponentUnlessAllIsAskedFor) {
  const ComponentMesh mesh = meshOfParts({knot({0, 0, 0}, 1), knot({5, 0, 0}, 2)});
  const auto left = [&](double rate) {
    return simplifyByCollapses(mesh, {}, {.method = SimplifyMethod::Qem, .rate = rate}).component;
  };
  EXPECT_EQ(left(0.4), std::vector<std::uint32_t>{1});
  EXPECT_EQ(left(0.9), std::vector<std::uint32_t>{1});
  EXPECT_TRUE(left(1).empty());
}

TEST(Collapses, AreTheSameForAnyNumberOfThreads) {
  std::vector<Faces> parts;
  for (unsigned i = 0; i < 30; ++i) parts.push_back(bumpyBlock(4, {2.9 * i, 0, 0}, 3, i));
  const ComponentMesh mesh = meshOfParts(parts);
  const auto collapsed = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return cornersOf(simplify(mesh, {.rate = 0.7}).mesh);
  };
  EXPECT_EQ(collapsed(1), collapsed(4));
}

TEST(Collapses, CanBeCancelled) {
  const ComponentMesh mesh = meshOfParts({bumpyBlock(12, {0, 0, 0}, 6, 1), bumpyBlock(12, {6, 0, 0}, 6, 2)});
  std::stop_source stop;
  const Progress progress(
      [&](double share, std::string_view) {
        if (share > 0.3) stop.request_stop();
      },
      stop.get_token());
  EXPECT_THROW((void)simplifyByCollapses(mesh, {}, {.method = SimplifyMethod::Qem, .rate = 0.9}, progress),
               Cancelled);
}

TEST(OptimalContraction, RestoresACornerThatWasCut) {
  // a cube's corner, its three edges cut by a small triangle: the cut contracts to the corner itself
  const double d = 0.1;
  const Vec3 x(1 - d, 1, 1), y(1, 1 - d, 1), z(1, 1, 1 - d);
  const ComponentMesh mesh = meshOfParts({{{Vec3(0, 1, 0), x, z},
                                           {Vec3(0, 1, 0), Vec3(0, 1, 1), x},
                                           {Vec3(0, 1, 0), z, Vec3(1, 1, 0)},
                                           {Vec3(0, 0, 1), y, x},
                                           {Vec3(0, 0, 1), x, Vec3(0, 1, 1)},
                                           {Vec3(0, 0, 1), Vec3(1, 0, 1), y},
                                           {Vec3(1, 0, 0), z, y},
                                           {Vec3(1, 0, 0), Vec3(1, 1, 0), z},
                                           {Vec3(1, 0, 0), y, Vec3(1, 0, 1)},
                                           {x, y, z},
                                           {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(1, 0, 0)},
                                           {Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(0, 1, 1), Vec3(0, 1, 0)},
                                           {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 1), Vec3(0, 0, 1)}}});
  const Simplified simplified = simplify(mesh, {.method = SimplifyMethod::QemOptimal, .rate = 0.25});
  const auto near = [](const Vec3& p) { return (p - Vec3(1, 1, 1)).norm() < 0.02; };
  EXPECT_EQ(std::count_if(simplified.mesh.vertices.begin(), simplified.mesh.vertices.end(), near), 1);
}

}  // namespace
}  // namespace lodestone
