#include "algorithms/simplification/component_contractions.h"

#include <random>
#include <set>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/deviation.h"
#include "algorithms/simplification/edge_collapses.h"
#include "algorithms/simplification/simplification.h"
#include "model/io/meshes/mesh_import.h"
#include "tests/support/part_models.h"
#include "tests/support/reference_contractions.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

using Corners = std::vector<std::array<Vec3, 3>>;

Corners cornersOf(const ComponentMesh& mesh) {
  Corners corners;
  for (const auto& [a, b, c] : mesh.triangles)
    corners.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  return corners;
}

/// Patches: the triangles within some distance of random places.
Admission randomAdmission(const ComponentMesh& mesh, unsigned seed, double share) {
  std::mt19937 random(seed);
  Admission admission;
  admission.triangles.assign(mesh.triangleCount(), false);
  admission.removable.assign(mesh.components.size(), false);
  const double reach = bounds(mesh).size().norm() / 6;
  while (std::count(admission.triangles.begin(), admission.triangles.end(), true) <
         share * mesh.triangleCount()) {
    const Vec3 at = mesh.vertices[mesh.triangles[random() % mesh.triangleCount()][0]];
    for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      if ((mesh.vertices[mesh.triangles[t][0]] - at).norm() < reach) admission.triangles[t] = true;
    }
  }
  return admission;
}

ComponentMesh manyParts(unsigned seed) {
  Faces open = bumpyBlock(3, {2.5, 0.5, 0}, 2, seed + 10);
  open.resize(open.size() - 5);
  return meshOfParts({bumpyBlock(4, {0, 0, 0}, 3, seed), open, bumpyBlock(2, {-2, -2, -2}, 1.5, seed + 30)});
}

void expectAsReference(const ComponentMesh& mesh, const SimplifyOptions& options,
                       const Admission& admission = {}) {
  const Corners expected = test::ReferenceContractions(mesh, options, admission).result();
  const Corners found = cornersOf(simplifyByCollapses(mesh, {}, options, {}, admission).mesh);
  SCOPED_TRACE(testing::Message() << "rate " << options.rate << ", error " << options.error << ", all "
                                  << admission.triangles.empty());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t t = 0; t < found.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) ASSERT_LT((found[t][i] - expected[t][i]).norm(), 1e-9);
  }
}

void expectAsReferenceHoweverAsked(const ComponentMesh& mesh, unsigned seed) {
  for (const double rate : {0.3, 0.7, 1.0}) {
    const SimplifyOptions options{.method = SimplifyMethod::Perception, .rate = rate};
    expectAsReference(mesh, options);
    expectAsReference(mesh, options, randomAdmission(mesh, seed, 0.5));
  }
  expectAsReference(mesh, {.method = SimplifyMethod::Perception, .rate = 1, .error = 0.02});
}

TEST(Contractions, AreThoseOfTheSlowReference) {
  Faces open = bumpyBlock(2, {2.5, 0.5, 0}, 2, 11);
  open.resize(open.size() - 5);
  expectAsReferenceHoweverAsked(meshOfParts({bumpyBlock(2, {0, 0, 0}, 3, 1), open}), 1);
}

TEST(LongContractions, AreThoseOfTheSlowReference) {
  for (unsigned seed = 0; seed < 12; ++seed) expectAsReferenceHoweverAsked(manyParts(seed), seed);
}

/// Every triangle that is not admitted is there to the last bit.
void expectTheRestStays(const ComponentMesh& mesh, const SimplifyOptions& options,
                        const Admission& admission) {
  const Classification classes =
      needsTopology(options.method) ? classify(mesh, options.gap) : Classification();
  const Simplified simplified = simplify(mesh, classes, options, {}, admission);
  std::multiset<std::array<double, 9>> left;
  const auto key = [](const std::array<Vec3, 3>& c) {
    return std::array<double, 9>{c[0].x(), c[0].y(), c[0].z(), c[1].x(), c[1].y(),
                                 c[1].z(), c[2].x(), c[2].y(), c[2].z()};
  };
  for (const auto& corners : cornersOf(simplified.mesh)) left.insert(key(corners));
  const Corners before = cornersOf(mesh);
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (admission.admits(t)) continue;
    const auto found = left.find(key(before[t]));
    ASSERT_NE(found, left.end()) << "triangle " << t;
    left.erase(found);
  }
}

constexpr std::array kMethods{SimplifyMethod::Perception, SimplifyMethod::Combined};

TEST(Admission, WhatItLeavesOutStaysToTheLastBit) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const ComponentMesh mesh = manyParts(seed);
    for (const SimplifyMethod method : kMethods) {
      for (const double rate : {0.2, 1.0})
        expectTheRestStays(mesh, {.method = method, .rate = rate}, randomAdmission(mesh, seed, 0.6));
    }
  }
}

ComponentMesh realMesh(const std::string& name) {
  const auto path = test::sharedData("D_meshes/" + name);
  if (path.empty()) return {};
  const Result<CityModel> city = readMesh(path, {}, {});
  const std::uint32_t first = 0;
  return city.ok() ? makeComponentMesh(*city, {&first, 1}) : ComponentMesh();
}

TEST(Admission, WhatItLeavesOutStaysToTheLastBitInRealBuildings) {
  for (const char* name : {"han_china_0ad/meshes/structural/han_house_a.dae",
                           "han_china_0ad/meshes/structural/han_temple.dae"}) {
    const ComponentMesh mesh = realMesh(name);
    if (mesh.triangles.empty()) GTEST_SKIP() << "no shared data";
    for (const SimplifyMethod method : kMethods)
      expectTheRestStays(mesh, {.method = method, .rate = 1}, randomAdmission(mesh, 3, 0.5));
  }
}

TEST(Admission, NothingAdmittedIsNothingChanged) {
  const ComponentMesh mesh = manyParts(1);
  Admission none{std::vector<bool>(mesh.triangleCount(), false), {}};
  EXPECT_TRUE(none.isEmpty());
  for (const SimplifyMethod method : kMethods) {
    const Simplified simplified = simplify(mesh, {.method = method, .rate = 0.9}, {}, none);
    EXPECT_EQ(simplified.mesh.triangles, mesh.triangles);
    EXPECT_EQ(simplified.mesh.vertices, mesh.vertices);
    EXPECT_EQ(simplified.operations, 0U);
  }
}

TEST(Admission, EverythingAdmittedCombinedIsTopologyAsLongAsNoComponentGoes) {
  const ComponentMesh mesh = manyParts(2);
  for (const double rate : {0.2, 0.5, 0.7}) {
    const Simplified topology = simplify(mesh, {.rate = rate});
    ASSERT_EQ(topology.componentsRemoved, 0U);
    const Simplified combined = simplify(mesh, {.method = SimplifyMethod::Combined, .rate = rate});
    EXPECT_EQ(combined.mesh.triangles, topology.mesh.triangles);
    EXPECT_EQ(combined.mesh.vertices, topology.mesh.vertices);
  }
}

TEST(Admission, OnlyWhatNobodySeesGoesWholeTheSmallestFirst) {
  std::vector<Faces> parts;
  for (int i = 0; i < 4; ++i) parts.push_back(boxFaces({3.0 * i, 0, 0}, {3.0 * i + 2 - 0.1 * i, 1, 1}));
  const ComponentMesh mesh = meshOfParts(parts);
  Perception perception;
  perception.pixels.assign(mesh.triangleCount(), 0);
  perception.classes.assign(mesh.triangleCount(), DetailClass::None);
  const Component& seen = mesh.components[2];
  perception.pixels[seen.firstTriangle] = 1;  // one pixel of one triangle is enough
  for (const SimplifyMethod method : kMethods) {
    SimplifyOptions options{.method = method, .rate = 0.5, .unseen = true};
    const auto left = [&] {
      return simplify(mesh, options, {}, admissionOf(mesh, perception, options)).component;
    };
    EXPECT_EQ(left(), (std::vector<std::uint32_t>{0, 2}));
    options.rate = 1;
    EXPECT_EQ(left(), (std::vector<std::uint32_t>{2}));
    options.unseen = false;
    EXPECT_TRUE(admissionOf(mesh, perception, options).isEmpty());
    EXPECT_EQ(left().size(), 4U);
  }
}

TEST(Admission, OfAStageHasTheClassesOfTheLowerOnes) {
  Perception perception;
  perception.pixels = {1, 1, 1, 1, 0};
  perception.classes = {DetailClass::None, DetailClass::Slight, DetailClass::Moderate, DetailClass::Dramatic,
                        DetailClass::None};
  const ComponentMesh mesh;
  const auto admitted = [&](int stage, bool unseen) {
    return admissionOf(mesh, perception, {.stage = stage, .unseen = unseen}).triangles;
  };
  EXPECT_EQ(admitted(1, false), (std::vector<bool>{false, false, false, true, false}));
  EXPECT_EQ(admitted(2, false), (std::vector<bool>{false, false, true, true, false}));
  EXPECT_EQ(admitted(3, true), (std::vector<bool>{false, true, true, true, true}));
}

/// A flat-topped bump of known height: contracting it away moves the surface by a share of that height.
TEST(Contractions, KeepToTheErrorThatIsAllowed) {
  const ComponentMesh mesh = meshOfParts({bumpyBlock(6, {0, 0, 0}, 6, 4)});
  std::size_t before = 0;
  for (const double error : {1e-4, 0.01, 0.05, 0.3}) {
    for (const SimplifyMethod method : kMethods) {
      const Simplified simplified = simplify(mesh, {.method = method, .rate = 1, .error = error});
      if (method == SimplifyMethod::Perception) {
        EXPECT_GT(mesh.triangleCount() + 1, simplified.mesh.triangleCount() + before);
        before = mesh.triangleCount() - simplified.mesh.triangleCount();
      }
      if (error < 1e-3) {
        EXPECT_EQ(simplified.mesh.triangleCount(), mesh.triangleCount());
      }
      // The error is a root mean square over planes: single points may be farther off.
      EXPECT_LE(hausdorffDistance(mesh, simplified.mesh), 4 * error);
    }
  }
  EXPECT_GT(before, mesh.triangleCount() / 2);
  for (const SimplifyMethod method : kMethods)
    EXPECT_GT(hausdorffDistance(mesh, simplify(mesh, {.method = method, .rate = 1}).mesh), 4 * 0.3);
}

TEST(Contractions, AreTheSameForAnyNumberOfThreads) {
  std::vector<Faces> parts;
  for (unsigned i = 0; i < 30; ++i) parts.push_back(bumpyBlock(4, {2.9 * i, 0, 0}, 3, i));
  const ComponentMesh mesh = meshOfParts(parts);
  for (const SimplifyMethod method : kMethods) {
    const auto contracted = [&](std::size_t threads) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      return cornersOf(
          simplify(mesh, {.method = method, .rate = 0.7}, {}, randomAdmission(mesh, 5, 0.9)).mesh);
    };
    EXPECT_EQ(contracted(1), contracted(4));
  }
}

}  // namespace
}  // namespace lodestone
