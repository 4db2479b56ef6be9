// Single-link, complete-link and k-means, and the pieces that clustering is made of.
#include <atomic>
#include <thread>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "algorithms/clustering/barrier_index.h"
#include "algorithms/clustering/linkages.h"
#include "algorithms/clustering/spanning_tree.h"
#include "tests/support/random_towns.h"
#include "tests/support/reference_clustering.h"

namespace lodestone {
namespace {

std::vector<FootprintTable> towns(std::uint32_t seed) {
  return {test::randomTown(seed, 70), test::griddedTown(seed, 70), test::oddTown(seed, 50),
          test::rowOfHouses(40, 1, seed % 2 == 0 ? 1 : 1.1)};
}

TEST(SingleLink, EqualsTheReference) {
  for (std::uint32_t seed = 0; seed < 15; ++seed) {
    for (const FootprintTable& town : towns(seed)) {
      SCOPED_TRACE(seed);
      const ClusterOptions options{.linkage = Linkage::Single, .neighbours = 2 + static_cast<int>(seed % 7)};
      const auto expected =
          test::referenceMerges(town, test::referenceGraph(town, options, test::plainCost), false);
      for (const std::size_t threads : {1U, 8U}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        EXPECT_EQ(makeDendrogram(town, options).merges, expected);
      }
    }
  }
}

TEST(SingleLink, WaitsAtBarriersToo) {
  const FootprintTable town = test::griddedTown(3, 80);
  const ClusterContext context{
      .barriers = {{Vec2(-5, 14.5), Vec2(300, 14.5)}, {Vec2(33, -5), Vec2(33, 300)}}};
  const ClusterOptions options{.linkage = Linkage::Single, .neighbours = 6};
  const auto cost = [&](std::uint32_t a, std::uint32_t b, double distance) {
    const ClosestPoints closest = closestPoints(town, a, b, options.distance);
    return test::ReferencePair{distance,
                               BarrierIndex(context.barriers).crossedBy(closest.onFirst, closest.onSecond)};
  };
  EXPECT_EQ(makeDendrogram(town, options, context).merges,
            test::referenceMerges(town, test::referenceGraph(town, options, cost), false));
}

/// Complete-link by looking at all pairs of buildings of all pairs of clusters, at every step.
std::vector<std::pair<std::uint32_t, std::uint32_t>> referenceCompleteLink(const FootprintTable& town) {
  std::vector<std::vector<std::uint32_t>> clusters;
  for (std::uint32_t b = 0; b < town.buildingCount(); ++b) {
    if (town.buildingRing[b] != town.buildingRing[b + 1]) clusters.push_back({b});
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joins;
  while (clusters.size() > 1) {
    auto best = std::tuple(std::numeric_limits<double>::infinity(), 0.0, 0U, 0U);
    std::pair<std::size_t, std::size_t> pair;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        double furthest = 0;
        for (const std::uint32_t x : clusters[i]) {
          for (const std::uint32_t y : clusters[j])
            furthest = std::max(furthest, test::vertexDistanceSquared(town, x, y));
        }
        const std::uint32_t a = *std::min_element(clusters[i].begin(), clusters[i].end());
        const std::uint32_t b = *std::min_element(clusters[j].begin(), clusters[j].end());
        const auto key =
            std::tuple(std::sqrt(furthest), static_cast<double>(clusters[i].size() * clusters[j].size()),
                       std::min(a, b), std::max(a, b));
        if (key < best) {
          best = key;
          pair = {i, j};
        }
      }
    }
    joins.emplace_back(std::get<2>(best), std::get<3>(best));
    clusters[pair.first].insert(clusters[pair.first].end(), clusters[pair.second].begin(),
                                clusters[pair.second].end());
    clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(pair.second));
  }
  return joins;
}

/// Smallest leaves of the two clusters of every merge.
std::vector<std::pair<std::uint32_t, std::uint32_t>> smallestLeaves(const Dendrogram& dendrogram) {
  std::vector<std::uint32_t> leaf(dendrogram.leafCount);
  std::iota(leaf.begin(), leaf.end(), 0U);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for (const Merge& merge : dendrogram.merges) {
    result.emplace_back(leaf[merge.a], leaf[merge.b]);
    leaf.push_back(leaf[merge.a]);
  }
  return result;
}

TEST(CompleteLink, EqualsTheReference) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    for (const FootprintTable& town :
         {test::randomTown(seed, 45), test::griddedTown(seed, 45), test::oddTown(seed, 35)}) {
      SCOPED_TRACE(seed);
      EXPECT_EQ(smallestLeaves(makeDendrogram(town, {.linkage = Linkage::Complete})),
                referenceCompleteLink(town));
    }
  }
}

TEST(CompleteLink, RefusesMoreThanItsMemoryAllows) {
  CityModel model;
  model.buildings.resize(kCompleteLinkLimit + 1);
  for (Building& building : model.buildings) building.footprint = {{test::rectangle(0, 0, 5, 5), {}}};
  EXPECT_FALSE(clusterContext(model, {.linkage = Linkage::Complete}, {}).ok());
  EXPECT_TRUE(clusterContext(model, {}, {}).ok());
}

/// Every leaf below the root once, children before parents, weights that never fall.
void expectTree(const Dendrogram& dendrogram, std::size_t leaves) {
  ASSERT_EQ(dendrogram.merges.size() + 1, leaves);
  std::vector<std::uint32_t> size(dendrogram.leafCount, 1);
  std::vector<bool> used(dendrogram.nodeCount(), false);
  double before = 0;
  for (const Merge& merge : dendrogram.merges) {
    ASSERT_LT(std::max(merge.a, merge.b), size.size());
    EXPECT_FALSE(used[merge.a] || used[merge.b] || merge.a == merge.b);
    used[merge.a] = used[merge.b] = true;
    EXPECT_EQ(merge.size, size[merge.a] + size[merge.b]);
    EXPECT_GE(merge.weight, before);
    before = merge.weight;
    size.push_back(merge.size);
  }
  EXPECT_EQ(size.back(), leaves);
}

TEST(KMeans, IsATreeOfFallingSquares) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const FootprintTable town = test::randomTown(seed, 120);
    expectTree(makeDendrogram(town, {.linkage = Linkage::KMeans}), 120);
    expectTree(makeDendrogram(test::griddedTown(seed, 90), {.linkage = Linkage::KMeans}), 90);
  }
  FootprintTable same;
  for (int i = 0; i < 33; ++i) test::addRing(same, test::rectangle(1, 2, 3, 4));
  expectTree(makeDendrogram(same, {.linkage = Linkage::KMeans}), 33);
}

TEST(KMeans, PartsVillagesThatStandApart) {
  FootprintTable town;
  for (int i = 0; i < 30; ++i)
    test::addRing(town, test::rectangle((i % 2) * 1000 + 12 * (i / 2 % 4), 12 * (i / 8), 8, 8));
  const Dendrogram dendrogram = makeDendrogram(town, {.linkage = Linkage::KMeans});
  const LeafOrder order = leafOrder(dendrogram);
  const Merge& root = dendrogram.merges.back();
  for (const NodeId child : {root.a, root.b}) {
    for (std::uint32_t i = 0; i < order.count[child]; ++i) {
      EXPECT_EQ(order.leaves[order.first[child] + i] % 2, order.leaves[order.first[child]] % 2);
    }
  }
}

TEST(SpanningTree, EqualsPrimsOverAllPairs) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> whole(0, 30);
    std::uniform_real_distribution<double> real(0, 30);
    std::vector<Vec2> points;
    for (int i = 0; i < 40 + 100 * static_cast<int>(seed); ++i) {
      if (seed % 3 == 0) points.emplace_back(real(random), real(random));
      if (seed % 3 == 1)
        points.emplace_back(whole(random), whole(random));       // many coincide, all distances tie
      if (seed % 3 == 2) points.emplace_back(whole(random), 7);  // collinear
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const SpanningEdge& edge : spanningTree(points)) edges.emplace_back(edge.a, edge.b);
    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(edges, test::referenceSpanningTree(points)) << seed;
  }
}

TEST(SpanningTree, EqualsPrimsAcrossTiles) {
  for (const bool gridded : {false, true}) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> whole(0, 120);
    std::uniform_real_distribution<double> real(0, 120);
    std::vector<Vec2> points;
    for (int i = 0; i < 20000; ++i) {
      points.push_back(gridded ? Vec2(whole(random), whole(random))
                               : Vec2(real(random), real(random) * real(random)));
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const SpanningEdge& edge : spanningTree(points)) edges.emplace_back(edge.a, edge.b);
    std::sort(edges.begin(), edges.end());
    EXPECT_TRUE(edges == test::referenceSpanningTree(points));
  }
}

/// The largest pause between a request to stop and Cancelled, over requests at many points of the work.
TEST(Clustering, StopsSoonWhereverItIs) {
  const FootprintTable town = test::griddedTown(1, 20000);
  for (const Linkage linkage : {Linkage::Legible, Linkage::Single, Linkage::KMeans}) {
    for (int step = 0; step < 8; ++step) {
      std::stop_source source;
      double asked = 0, last = 0;
      const Progress progress(
          [&](double done, const std::string&) {
            last = done;
            if (done < step / 8.0 || source.stop_requested()) return;
            asked = done;
            source.request_stop();
          },
          source.get_token());
      EXPECT_THROW((void)makeDendrogram(town, {.linkage = linkage}, {}, progress), Cancelled);
      EXPECT_LT(last, asked + 0.05);  // hardly anything was begun after that
    }
  }
}

TEST(Clustering, ReportsProgressThatNeverFallsAndEnds) {
  double last = 0;
  (void)makeDendrogram(test::randomTown(1, 500), {}, {}, Progress([&](double done, const std::string&) {
                         EXPECT_GE(done, last);
                         last = done;
                       }));
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace lodestone
