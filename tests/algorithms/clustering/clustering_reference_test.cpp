// The dendrogram against the paper's literal algorithm run by brute force.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/support/random_towns.h"
#include "tests/support/reference_clustering.h"

namespace lodestone {
namespace {

using test::plainCost;

void expectSameMerges(const std::vector<Merge>& actual, const std::vector<Merge>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_EQ(actual[i].a, expected[i].a) << "merge " << i;
    ASSERT_EQ(actual[i].b, expected[i].b) << "merge " << i;
    ASSERT_EQ(actual[i], expected[i]) << "merge " << i;
  }
}

/// The same for 1, 2 and 8 threads, and equal to the reference.
void expectReference(const FootprintTable& town, const ClusterOptions& options) {
  const auto graph = test::referenceGraph(town, options, plainCost);
  const std::vector<Merge> expected = test::referenceMerges(town, graph, options.linkage == Linkage::Legible);
  for (const std::size_t threads : {1U, 2U, 8U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Dendrogram dendrogram = makeDendrogram(town, options);
    expectSameMerges(dendrogram.merges, expected);
    EXPECT_EQ(dendrogram.leafCount, town.buildingCount());
  }
}

class ClusteringReference : public testing::TestWithParam<FootprintDistance> {};
INSTANTIATE_TEST_SUITE_P(Distances, ClusteringReference,
                         testing::Values(FootprintDistance::Vertex, FootprintDistance::Outline),
                         [](const auto& test) {
                           return test.param == FootprintDistance::Vertex ? "Vertex" : "Outline";
                         });

TEST_P(ClusteringReference, RandomTowns) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const ClusterOptions options{.distance = GetParam(), .neighbours = std::vector{1, 3, 6, 50}[seed % 4]};
    expectReference(test::randomTown(seed, 60 + 3 * static_cast<int>(seed)), options);
  }
}

TEST_P(ClusteringReference, GriddedTownsWhoseHousesTouch) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const ClusterOptions options{.distance = GetParam(), .neighbours = std::vector{2, 4, 9, 50}[seed % 4]};
    expectReference(test::griddedTown(seed, 40 + 7 * static_cast<int>(seed)), options);
  }
}

TEST_P(ClusteringReference, OddTowns) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const ClusterOptions options{.distance = GetParam(), .neighbours = std::vector{1, 2, 5, 50}[seed % 4]};
    expectReference(test::oddTown(seed, 30 + 2 * static_cast<int>(seed)), options);
  }
}

TEST_P(ClusteringReference, Rows) {
  for (const double growth : {0.97, 1.0, 1.03}) {
    for (const double gap : {0.0, 2.0}) {
      expectReference(test::rowOfHouses(70, gap, growth), {.distance = GetParam(), .neighbours = 4});
    }
  }
}

TEST_P(ClusteringReference, ManyEqualFootprints) {
  FootprintTable town;
  for (int i = 0; i < 50; ++i) test::addRing(town, test::rectangle(0, 0, 5, 5));
  for (int i = 0; i < 20; ++i) test::addRing(town, test::rectangle(100, 0, 5, 5));
  expectReference(town, {.distance = GetParam(), .neighbours = 3});
}

TEST_P(ClusteringReference, FewBuildings) {
  FootprintTable town;
  expectReference(town, {.distance = GetParam()});
  town.add({}, 0, 0);
  expectReference(town, {.distance = GetParam()});
  test::addRing(town, test::rectangle(0, 0, 5, 5));
  expectReference(town, {.distance = GetParam()});
  test::addRing(town, test::rectangle(8, 0, 5, 5));
  expectReference(town, {.distance = GetParam()});
  test::addRing(town, test::rectangle(8, 9, 5, 5));
  expectReference(town, {.distance = GetParam(), .neighbours = 1});
}

TEST(Clustering, TouchingHousesMakeAFlatTree) {
  // methods.md 1.2: 40 touching houses make a tree of depth 6–7, not 39.
  EXPECT_LE(makeDendrogram(test::rowOfHouses(40, 0, 1), {}).depth, 7U);
}

}  // namespace
}  // namespace lodestone
