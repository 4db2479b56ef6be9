// Clustering of real footprints against the reference; skipped where the data is absent.
#include <gtest/gtest.h>

#include "algorithms/clustering/barrier_index.h"
#include "model/io/read_city.h"
#include "tests/support/reference_clustering.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

/// `count` footprints from the middle of a table, as a table of their own: neighbours in the file are mostly
/// so in the town.
FootprintTable someOf(const FootprintTable& table, std::size_t first, std::size_t count) {
  FootprintTable some;
  for (std::size_t b = first; b < std::min(first + count, table.buildingCount()); ++b)
    some.add(table.footprint(b), 0, 0);
  return some;
}

class RealTown : public testing::Test {
 protected:
  void load(const std::string& path) {
    const std::filesystem::path file = test::sharedData(path);
    if (file.empty()) GTEST_SKIP() << "shared data not present";
    Result<CityModel> result = readCity({file});
    ASSERT_TRUE(result.ok());
    city_ = std::move(*result);
    table_ = footprintTable(city_);
  }

  CityModel city_;
  FootprintTable table_;
};

void expectReference(const FootprintTable& town, const ClusterOptions& options) {
  const auto graph = test::referenceGraph(town, options, test::plainCost);
  EXPECT_EQ(makeDendrogram(town, options).merges,
            test::referenceMerges(town, graph, options.linkage == Linkage::Legible));
}

TEST_F(RealTown, PartsOfHancockEqualTheReference) {
  load("C_footprints/hancock_ms_41k_shp/BuildingFootprintsOSM.gpkg");
  if (IsSkipped() || HasFatalFailure()) return;
  for (std::size_t part = 0; part < 4; ++part) {
    const FootprintTable town = someOf(table_, part * table_.buildingCount() / 4, 130);
    expectReference(town, {.neighbours = 3 + 8 * static_cast<int>(part)});
    expectReference(town, {.distance = FootprintDistance::Outline, .neighbours = 5});
    expectReference(town, {.linkage = Linkage::Single, .neighbours = 10});
  }
}

TEST_F(RealTown, GeoclimateEqualsTheReferenceWithRoadsAsBarriers) {
  load("C_footprints/geoclimate_heights_roads/BUILDING.geojson");
  if (IsSkipped() || HasFatalFailure()) return;
  const auto roads = readLines(test::sharedData("C_footprints/geoclimate_heights_roads/ROAD.geojson"), city_);
  ASSERT_TRUE(roads.ok());
  EXPECT_GT(roads->lines.size(), 800U);
  for (std::size_t first : {0U, 700U, 1900U}) {
    const FootprintTable town = someOf(table_, first, 120);
    for (const double factor : {0.0, 5.0}) {
      const ClusterOptions options{.neighbours = 8, .barrierFactor = factor};
      const BarrierIndex index(roads->lines);
      const auto cost = [&](std::uint32_t a, std::uint32_t b, double distance) {
        const ClosestPoints closest = closestPoints(town, a, b, options.distance);
        const bool crosses = index.crossedBy(closest.onFirst, closest.onSecond);
        return test::ReferencePair{crosses && factor > 0 ? factor * distance : distance,
                                   crosses && factor == 0};
      };
      EXPECT_EQ(makeDendrogram(town, options, {.barriers = roads->lines}).merges,
                test::referenceMerges(town, test::referenceGraph(town, options, cost)));
    }
  }
}

TEST_F(RealTown, RoadsPartTheWholeOfGeoclimate) {
  load("C_footprints/geoclimate_heights_roads/BUILDING.geojson");
  if (IsSkipped() || HasFatalFailure()) return;
  const auto roads = readLines(test::sharedData("C_footprints/geoclimate_heights_roads/ROAD.geojson"), city_);
  ASSERT_TRUE(roads.ok());
  const auto context = clusterContext(city_, {.attribute = ""}, {*roads});
  ASSERT_TRUE(context.ok());
  const Dendrogram parted = makeDendrogram(table_, {}, *context);
  const Dendrogram plain = makeDendrogram(table_, {});
  EXPECT_EQ(parted.merges.size(), plain.merges.size());
  EXPECT_EQ(plain.merges.size() + 1, table_.buildingCount());
  EXPECT_NE(parted.merges, plain.merges);
  double before = 0;
  for (const Merge& merge : parted.merges) {
    EXPECT_GE(merge.weight, before);
    before = merge.weight;
  }
}

}  // namespace
}  // namespace lodestone
