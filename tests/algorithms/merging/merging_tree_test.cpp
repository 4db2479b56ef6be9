// makeClusterTree(): rules of methods.md 1.3 and 1.4 at every node, against brute force.
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "algorithms/footprints/footprints.h"
#include "algorithms/geometry/predicates.h"
#include "algorithms/merging/merging.h"
#include "algorithms/synthesis/synthesis.h"
#include "tests/support/plain_dendrogram.h"
#include "tests/support/random_polygons.h"
#include "tests/support/reference_hull.h"

namespace lodestone {
namespace {

using test::Random;

/// Houses that overlap, touch, coincide and nest; some with courtyards, some in two pieces.
FootprintTable crowdedTown(unsigned seed, int count) {
  Random random(seed);
  FootprintTable table;
  for (int i = 0; i < count; ++i) {
    MultiPolygon footprint{{test::randomGridHouse(random, 12), {}}};
    if (i % 7 == 3) footprint.push_back({test::randomGridHouse(random, 12), {}});
    if (i % 7 == 5) {
      const double x = random.integer(0, 8);
      const double y = random.integer(0, 8);
      footprint = {{{Vec2(x, y), Vec2(x + 5, y), Vec2(x + 5, y + 5), Vec2(x, y + 5)},
                    {{Vec2(x + 1, y + 1), Vec2(x + 1, y + 4), Vec2(x + 4, y + 4), Vec2(x + 4, y + 1)}}}};
    }
    table.add(unite(footprint), random.real(0, 3), random.real(3, 30));
  }
  return table;
}

ClusterTree treeOf(FootprintTable table, const MergeOptions& options = {}, int skew = 2) {
  const auto footprints = std::make_shared<const FootprintTable>(std::move(table));
  return makeClusterTree(
      footprints, std::make_shared<const Dendrogram>(test::plainDendrogram(*footprints, skew)), options);
}

std::vector<std::vector<std::uint32_t>> buildingsBelow(const ClusterTree& tree) {
  std::vector<std::vector<std::uint32_t>> below(tree.nodes.size());
  for (NodeId id = 0; id < tree.nodes.size(); ++id) {
    if (tree.isLeaf(id)) {
      below[id] = {id};
    } else {
      below[id] = below[tree.nodes[id].a];
      const auto& other = below[tree.nodes[id].b];
      below[id].insert(below[id].end(), other.begin(), other.end());
    }
  }
  return below;
}

double exactUnionArea(const FootprintTable& table, const std::vector<std::uint32_t>& buildings) {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto exact = [](const Ring& ring) {
    CGAL::Polygon_2<Kernel> polygon;
    for (const Vec2& p : ring) polygon.push_back(Kernel::Point_2(p.x(), p.y()));
    return polygon;
  };
  CGAL::Polygon_set_2<Kernel> set;
  for (const std::uint32_t building : buildings) {
    for (const Polygon& polygon : table.footprint(building)) {
      CGAL::Polygon_with_holes_2<Kernel> with(exact(polygon.outer));
      for (const Ring& hole : polygon.holes) with.add_hole(exact(hole));
      set.join(with);
    }
  }
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> parts;
  set.polygons_with_holes(std::back_inserter(parts));
  double sum = 0;
  for (const auto& part : parts) {
    sum += CGAL::to_double(part.outer_boundary().area());
    for (const auto& hole : part.holes()) sum += CGAL::to_double(hole.area());
  }
  return sum;
}

Ring hullRing(const ClusterTree& tree, NodeId id) {
  return {tree.hull(id).begin(), tree.hull(id).end()};
}

void expectHullRules(const ClusterTree& tree, const std::string& what) {
  for (NodeId id = 0; id < tree.nodes.size(); ++id) {
    const ClusterNode& node = tree.nodes[id];
    if (tree.isLeaf(id)) continue;
    const std::vector<Ring> children{hullRing(tree, node.a), hullRing(tree, node.b)};
    const auto target = static_cast<std::size_t>(
        tree.options.edgeRatio * static_cast<double>(children[0].size() + children[1].size()));
    ASSERT_EQ(test::brokenRule(hullRing(tree, id), children, target), "") << what << ", node " << id;
    ASSERT_EQ(node.faces, (FaceCount{2ULL * node.edges - 2, 4ULL * node.edges - 4}));
    ASSERT_GE(node.negative, 0);
  }
}

TEST(ClusterTree, HullRulesHoldInCrowdedTowns) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    for (const double ratio : {0.5, 0.75, 1.0}) {
      expectHullRules(treeOf(crowdedTown(seed, 14), {ratio}, 2 + static_cast<int>(seed % 3)),
                      "seed " + std::to_string(seed));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(ClusterTree, NegativeSpaceIsHullMinusTheExactUnion) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const ClusterTree tree = treeOf(crowdedTown(seed, 16), {}, 2 + static_cast<int>(seed % 3));
    const auto below = buildingsBelow(tree);
    for (NodeId id = 0; id < tree.nodes.size(); ++id) {
      const double expected =
          std::max(0.0, signedArea(hullRing(tree, id)) - exactUnionArea(*tree.footprints, below[id]));
      ASSERT_NEAR(tree.nodes[id].negative, expected, 1e-9) << "seed " << seed << ", node " << id;
    }
  }
}

TEST(ClusterTree, HeightsAreMeansWeightedByFootprintAreaAndTopsAreExtremes) {
  const ClusterTree tree = treeOf(crowdedTown(3, 30));
  const auto below = buildingsBelow(tree);
  const FootprintTable& table = *tree.footprints;
  for (NodeId id = 0; id < tree.nodes.size(); ++id) {
    double weight = 0, height = 0, base = 0, top = -1e9, low = 1e9;
    Box2 box;
    for (const std::uint32_t b : below[id]) {
      const double ground = area(table.footprint(b));
      weight += ground;
      height += ground * table.height[b];
      base += ground * table.base[b];
      top = std::max(top, table.base[b] + table.height[b]);
      low = std::min(low, table.base[b]);
      box.add(bounds(table.footprint(b)));
    }
    const ClusterNode& node = tree.nodes[id];
    EXPECT_NEAR(node.height, height / weight, 1e-9);
    EXPECT_NEAR(node.base, base / weight, 1e-9);
    EXPECT_EQ(node.maxTop, top);
    EXPECT_EQ(node.minBase, low);
    EXPECT_EQ(node.box.min, box.min);
    EXPECT_EQ(node.box.max, box.max);
    EXPECT_EQ(node.size, below[id].size());
  }
}

TEST(ClusterTree, LeavesKeepTheirOutlineAndCountTheirOwnPolygons) {
  FootprintTable table;
  const Ring outer{Vec2(0, 0), Vec2(2, 0), Vec2(4, 0), Vec2(4, 4), Vec2(0, 4)};  // one vertex on a side
  const Ring hole{Vec2(1, 1), Vec2(1, 2), Vec2(2, 2), Vec2(2, 1)};
  table.add({{outer, {hole}}}, 0, 5);
  table.add({{{Vec2(9, 0), Vec2(10, 0), Vec2(10, 1)}, {}}, {{Vec2(9, 3), Vec2(10, 3), Vec2(10, 4)}, {}}}, 0,
            5);
  const ClusterTree tree = treeOf(table);
  EXPECT_EQ(hullRing(tree, 0), (Ring{Vec2(0, 0), Vec2(4, 0), Vec2(4, 4), Vec2(0, 4)}));
  EXPECT_EQ(tree.nodes[0].faces.polygons, 2 * 9 - 2 + 2);
  EXPECT_DOUBLE_EQ(tree.nodes[0].negative, 1);
  EXPECT_EQ(tree.nodes[1].edges, 4U);  // two triangles merged: floor(0.75 · 6)
  EXPECT_EQ(tree.nodes[1].faces.polygons, 2 * (2 * 3 - 2));
  EXPECT_EQ(tree.buildingFaces.polygons, 18U + 8U);
}

TEST(ClusterTree, BuildingsWithoutFootprintAddNothing) {
  FootprintTable table;
  table.add({}, 0, 5);
  table.add({{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)}, {}}}, 0, 5);
  table.add({}, 0, 5);
  const ClusterTree tree = treeOf(table);
  EXPECT_EQ(tree.nodes.back().edges, 3U);
  EXPECT_DOUBLE_EQ(tree.nodes.back().negative, 0);
}

TEST(ClusterTree, NoneAndOneBuilding) {
  EXPECT_TRUE(treeOf({}).nodes.empty());
  FootprintTable table;
  table.add({{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)}, {}}}, 0, 5);
  EXPECT_EQ(treeOf(table).nodes.size(), 1U);
}

TEST(ClusterTree, SameForAnyNumberOfThreads) {
  const FootprintTable table = footprintTable(synthesiseCity({CityPreset::Town, 0, 3}));
  const ClusterTree many = treeOf(table);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const ClusterTree single = treeOf(table);
  EXPECT_EQ(many.hullVertices, single.hullVertices);
  for (NodeId id = 0; id < many.nodes.size(); ++id) {
    ASSERT_EQ(many.nodes[id].negative, single.nodes[id].negative);
    ASSERT_EQ(many.nodes[id].height, single.nodes[id].height);
  }
}

TEST(ClusterTree, StopsWhenAskedAndTellsTheSink) {
  const auto footprints = std::make_shared<const FootprintTable>(crowdedTown(1, 9));
  const auto dendrogram = std::make_shared<const Dendrogram>(test::plainDendrogram(*footprints));
  int told = 0;
  (void)makeClusterTree(footprints, dendrogram, {}, {}, [&](std::string_view, const Artifact&) { ++told; });
  EXPECT_EQ(told, 1);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)makeClusterTree(footprints, dendrogram, {}, Progress({}, stop.get_token())), Cancelled);
}

TEST(ClusterTree, HullRulesHoldInATownOfStreetsAndCourtyards) {
  expectHullRules(treeOf(footprintTable(synthesiseCity({CityPreset::Town, 150, 7}))), "town");
}

}  // namespace
}  // namespace lodestone
