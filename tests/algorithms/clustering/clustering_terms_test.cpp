// Barriers, the attribute term, and what clustering takes from a city model.
#include <gtest/gtest.h>

#include "algorithms/clustering/barrier_index.h"
#include "tests/support/random_towns.h"
#include "tests/support/reference_clustering.h"

namespace lodestone {
namespace {

using Lines = std::vector<std::vector<Vec2>>;

Lines randomStreets(std::uint32_t seed, double extent) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-0.1 * extent, 1.1 * extent);
  Lines lines(6);
  for (auto& line : lines) {
    for (int i = 0; i < 4; ++i) line.emplace_back(place(random), place(random));
  }
  // A street on whole metres, through corners of gridded houses.
  lines.push_back({Vec2(0, 0.25 * extent), Vec2(extent, 0.25 * extent)});
  lines.push_back({Vec2(20, -5), Vec2(20, 30), Vec2(20, extent)});
  return lines;
}

/// The rule of barrier_index.h over all segments, without an index.
bool crossesAny(const Lines& lines, const Vec2& p, const Vec2& q) {
  for (const auto& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (crossesBarrier(p, q, line[i - 1], line[i])) return true;
    }
  }
  return false;
}

test::ReferenceCost costOf(const FootprintTable& town, const ClusterOptions& options,
                           const ClusterContext& context) {
  return [&](std::uint32_t a, std::uint32_t b, double distance) {
    test::ReferencePair pair{distance, false};
    if (!context.attribute.empty()) {
      const double difference = std::abs(context.attribute[a] - context.attribute[b]);
      const double units = context.attributeIsCategory ? (difference > 0 ? 1 : 0) : difference;
      if (!std::isnan(difference)) pair.distance += context.attributeWeight * units;
    }
    const ClosestPoints closest = closestPoints(town, a, b, options.distance);
    if (crossesAny(context.barriers, closest.onFirst, closest.onSecond)) {
      pair.forbidden = options.barrierFactor == 0;
      if (!pair.forbidden) pair.distance *= options.barrierFactor;
    }
    return pair;
  };
}

void expectReference(const FootprintTable& town, const ClusterOptions& options,
                     const ClusterContext& context) {
  const auto graph = test::referenceGraph(town, options, costOf(town, options, context));
  EXPECT_EQ(makeDendrogram(town, options, context).merges,
            test::referenceMerges(town, graph, options.linkage == Linkage::Legible));
}

TEST(ClusteringBarriers, EqualTheReference) {
  for (std::uint32_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    ClusterOptions options{.neighbours = 2 + static_cast<int>(seed % 5)};
    options.barrierFactor = std::vector<double>{0, 3, 0.5}[seed % 3];
    options.distance = seed % 2 == 0 ? FootprintDistance::Vertex : FootprintDistance::Outline;
    const ClusterContext context{.barriers = randomStreets(seed, 200)};
    expectReference(test::randomTown(seed, 60), options, context);
    expectReference(test::griddedTown(seed, 60), options, context);
    expectReference(test::oddTown(seed, 40), options, context);
  }
}

TEST(ClusteringBarriers, ForbiddenPairsWaitForAllOthers) {
  // Two rows of houses 12 m apart, the houses of a row 20 m apart, with a river between the rows.
  FootprintTable town;
  for (int i = 0; i < 10; ++i) {
    test::addRing(town, test::rectangle(30 * i, 0, 10, 10));
    test::addRing(town, test::rectangle(30 * i, 22, 10, 10));
  }
  const ClusterContext river{.barriers = {{Vec2(-50, 16), Vec2(400, 16)}}};
  const Dendrogram dendrogram = makeDendrogram(town, {}, river);
  ASSERT_EQ(dendrogram.merges.size(), 19U);
  std::vector<int> side(dendrogram.nodeCount());
  for (NodeId leaf = 0; leaf < 20; ++leaf) side[leaf] = static_cast<int>(leaf % 2);
  for (std::size_t m = 0; m + 1 < dendrogram.merges.size(); ++m) {
    const Merge& merge = dendrogram.merges[m];
    EXPECT_EQ(side[merge.a], side[merge.b]) << "merge " << m;
    side[20 + m] = side[merge.a];
  }
  EXPECT_EQ(dendrogram.merges.back().distance, 12);
  EXPECT_GE(dendrogram.merges.back().weight, dendrogram.merges[17].weight);
}

TEST(ClusteringAttribute, EqualsTheReference) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const FootprintTable town = seed % 2 == 0 ? test::randomTown(seed, 70) : test::griddedTown(seed, 70);
    ClusterContext context{.attributeWeight = 2.5, .attributeIsCategory = seed % 3 == 0};
    std::mt19937 random(seed);
    for (std::size_t b = 0; b < town.buildingCount(); ++b) {
      context.attribute.push_back(random() % 7 == 0 ? std::numeric_limits<double>::quiet_NaN()
                                                    : static_cast<double>(random() % 5));
    }
    if (seed % 4 == 1) context.barriers = randomStreets(seed, 150);
    expectReference(town, {.neighbours = 5, .barrierFactor = seed % 8 == 1 ? 0.0 : 4.0}, context);
  }
}

TEST(BarrierIndex, EqualsAllSegmentsOneByOne) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    // Whole numbers make segments meet in vertices and run along each other; real ones do not.
    std::uniform_int_distribution<int> whole(-5, 30);
    std::uniform_real_distribution<double> real(-5, 30);
    const auto point = [&] {
      return seed % 2 == 0 ? Vec2(whole(random), whole(random)) : Vec2(real(random), real(random));
    };
    Lines lines(1 + seed * 3);
    for (auto& line : lines) {
      line.push_back(point());
      for (int i = 0; i < 3; ++i)
        line.push_back(line.back() + (point() - point()) * (seed % 3 == 0 ? 1 : 0.125));
    }
    const BarrierIndex index(lines);
    for (int i = 0; i < 2000; ++i) {
      const Vec2 p = point() * (i % 50 == 0 ? 1000 : 1);
      const Vec2 q = i % 2 == 0 ? point() : p + (point() - point()) / 16;
      ASSERT_EQ(index.crossedBy(p, q), crossesAny(lines, p, q)) << seed << " " << i;
      ASSERT_EQ(index.crossedBy(q, p), index.crossedBy(p, q));
    }
  }
}

TEST(BarrierIndex, CrossesALineOnceAtItsVertex) {
  const Vec2 a(0, 0);
  const Vec2 b(5, 5);
  const Vec2 c(10, 0);
  const Vec2 below(5, -3);
  const Vec2 above(5, 9);
  EXPECT_NE(crossesBarrier(below, above, a, b), crossesBarrier(below, above, b, c));
  EXPECT_TRUE(BarrierIndex({{a, b, c}}).crossedBy(below, above));
  EXPECT_FALSE(BarrierIndex({{a, b, c}}).crossedBy(below, below));
  EXPECT_FALSE(BarrierIndex({{a, c}}).crossedBy(a, c));  // along it
  EXPECT_FALSE(BarrierIndex({}).crossedBy(a, c));
}

Building buildingWith(const std::string& id, const std::string& name, AttributeValue value) {
  Building building;
  building.object.id = id;
  building.object.attributes.set(name, std::move(value));
  building.footprint = {{test::rectangle(0, 0, 5, 5), {}}};
  return building;
}

std::vector<Code> codes(const Diagnostics& diagnostics) {
  std::vector<Code> result;
  for (const Diagnostic& d : diagnostics) result.push_back(d.code);
  return result;
}

TEST(ClusterContext, ReadsNumbersAndSaysWhatIsMissing) {
  CityModel model;
  model.buildings = {buildingWith("a", "floors", std::int64_t{3}),
                     buildingWith("b", "floors", std::string("4.5")), buildingWith("c", "other", true)};
  const auto context = clusterContext(model, {.attribute = "floors=2.5"}, {});
  ASSERT_TRUE(context.ok());
  EXPECT_EQ(context->attributeWeight, 2.5);
  EXPECT_FALSE(context->attributeIsCategory);
  EXPECT_EQ(context->attribute[0], 3);
  EXPECT_EQ(context->attribute[1], 4.5);
  EXPECT_TRUE(std::isnan(context->attribute[2]));
  EXPECT_EQ(codes(context.diagnostics), std::vector{Code::AttributeMissing});
}

TEST(ClusterContext, NumbersTextsInAlphabeticalOrder) {
  CityModel model;
  model.buildings = {buildingWith("a", "use", std::string("shop")),
                     buildingWith("b", "use", std::string("house")),
                     buildingWith("c", "use", std::string("shop"))};
  const auto context = clusterContext(model, {.attribute = "use=10"}, {});
  ASSERT_TRUE(context.ok());
  EXPECT_TRUE(context->attributeIsCategory);
  EXPECT_EQ(context->attribute, (std::vector<double>{1, 0, 1}));
}

TEST(ClusterContext, RefusesWhatItCannotUse) {
  CityModel model;
  model.buildings = {buildingWith("a", "use", std::string("shop")),
                     buildingWith("b", "use", std::string("shop"))};
  for (const std::string bad : {"use", "=3", "use=", "use=x", "use=-1"}) {
    const auto context = clusterContext(model, {.attribute = bad}, {});
    EXPECT_FALSE(context.ok()) << bad;
    EXPECT_EQ(codes(context.diagnostics), std::vector{Code::OptionBadValue}) << bad;
  }
  const auto unknown = clusterContext(model, {.attribute = "height=1"}, {});
  EXPECT_FALSE(unknown.ok());
  EXPECT_EQ(codes(unknown.diagnostics), std::vector{Code::FieldMissing});
  EXPECT_FALSE(clusterContext(model, {.neighbours = 0}, {}).ok());
}

TEST(ClusterContext, NamesBuildingsWithoutFootprint) {
  CityModel model;
  model.buildings = {buildingWith("a", "x", true), buildingWith("b", "x", true)};
  model.buildings[1].footprint.clear();
  const auto context = clusterContext(model, {}, {LineLayer{"roads", {{Vec2(0, 0), Vec2(1, 1)}}, {}}});
  ASSERT_TRUE(context.ok());
  EXPECT_EQ(context->barriers.size(), 1U);
  ASSERT_EQ(codes(context.diagnostics), std::vector{Code::LeafWithoutFootprint});
  EXPECT_EQ(context.diagnostics[0].object, "b");
}

}  // namespace
}  // namespace lodestone
