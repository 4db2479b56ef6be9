// makeUniformCut() against a reference that follows the tree node by node and looks at every building, and
// its rules as properties.
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "algorithms/clustering/clustering.h"
#include "algorithms/footprints/import.h"
#include "algorithms/merging/cutting.h"
#include "algorithms/merging/merging.h"
#include "algorithms/synthesis/synthesis.h"
#include "tests/support/plain_dendrogram.h"
#include "tests/support/random_towns.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

ClusterTree treeOf(FootprintTable table, int skew = 0) {
  const auto footprints = std::make_shared<const FootprintTable>(std::move(table));
  return makeClusterTree(
      footprints, std::make_shared<const Dendrogram>(skew > 0 ? test::plainDendrogram(*footprints, skew)
                                                              : makeDendrogram(*footprints, {})));
}

/// Houses anywhere, of heights that rise and fall from one to the next: full of landmarks.
FootprintTable raggedTown(std::uint32_t seed, int buildings) {
  FootprintTable town = test::randomTown(seed, buildings);
  std::mt19937 random(seed);
  std::lognormal_distribution<double> height(2.2, 0.8);
  for (std::size_t i = 0; i < town.buildingCount(); ++i) town.height[i] = height(random);
  return town;
}

/// The rule of the header by recursion: the lightest of all allowed cuts below a node, the coarser of equals.
class Reference {
 public:
  Reference(const ClusterTree& tree, double tolerance, double alphaHeight)
      : tree_(tree), tolerance_(tolerance), alphaHeight_(alphaHeight) {}

  struct Drawn {
    std::vector<NodeId> nodes;
    std::uint64_t polygons = 0;
  };
  Drawn below(NodeId id) {
    const ClusterNode& node = tree_.nodes[id];
    if (tree_.isLeaf(id)) return {{id}, node.faces.polygons};
    Drawn apart = below(node.a);
    const Drawn b = below(node.b);
    apart.nodes.insert(apart.nodes.end(), b.nodes.begin(), b.nodes.end());
    apart.polygons += b.polygons;
    Drawn whole{{id}, node.faces.polygons};
    bool allowed = true;
    forEachBelow(id, [&](NodeId inner) {
      const ClusterNode& at = tree_.nodes[inner];
      if (!tree_.isLeaf(inner)) {
        const double side = std::max(at.negative, at.gap * at.height);
        allowed = allowed && std::sqrt(side) <= tolerance_;
      } else if (at.base + at.height > node.base + node.height + alphaHeight_) {
        whole.nodes.push_back(inner);
        whole.polygons += at.faces.polygons;
      }
    });
    return allowed && whole.polygons <= apart.polygons ? whole : apart;
  }

 private:
  void forEachBelow(NodeId id, const std::function<void(NodeId)>& visit) {
    visit(id);
    if (tree_.isLeaf(id)) return;
    forEachBelow(tree_.nodes[id].a, visit);
    forEachBelow(tree_.nodes[id].b, visit);
  }

  const ClusterTree& tree_;
  double tolerance_, alphaHeight_;
};

void expectAsReference(const ClusterTree& tree) {
  const CutOptions options{100, 2};
  for (const double tolerance : {0.0, 1.0, 2.0, 5.0, 10.0, 40.0, 1e4}) {
    const Cut cut = makeUniformCut(tree, options, tolerance);
    const auto root = static_cast<NodeId>(tree.nodes.size() - 1);
    Reference::Drawn expected = Reference(tree, tolerance, tolerance * 0.2).below(root);
    std::vector<NodeId> drawn;
    for (const DrawnNode& node : cut.drawn) drawn.push_back(node.node);
    ASSERT_EQ(drawn, expected.nodes) << "tolerance " << tolerance;
    ASSERT_EQ(cut.faces.polygons, expected.polygons) << "tolerance " << tolerance;
    EXPECT_TRUE(cut.culled.empty());
  }
}

/// A coarser level is never heavier than a finer one, nor than all buildings.
void expectLighterAndLighter(const ClusterTree& tree) {
  std::uint64_t before = tree.buildingFaces.polygons;
  for (double tolerance = 0.5; tolerance < 500; tolerance *= 1.3) {
    const std::uint64_t now = makeUniformCut(tree, {100, 2}, tolerance).faces.polygons;
    ASSERT_LE(now, before) << "tolerance " << tolerance;
    before = now;
  }
}

TEST(UniformCut, IsTheReferences) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    expectAsReference(treeOf(raggedTown(seed, 60)));
    expectAsReference(treeOf(test::randomTown(seed, 40), 2 + static_cast<int>(seed % 3)));
    expectAsReference(treeOf(test::griddedTown(seed, 40)));
    if (HasFatalFailure()) return;
  }
  expectAsReference(treeOf(footprintTable(synthesiseCity({CityPreset::Town, 0, 5})), 3));
}

TEST(UniformCut, IsNeverHeavierThanAFinerOne) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    expectLighterAndLighter(treeOf(raggedTown(seed, 200)));
    expectLighterAndLighter(treeOf(raggedTown(seed, 100), 7));
    if (HasFatalFailure()) return;
  }
}

// A tower beside a low house: joined, it would be drawn twice, as itself and in the cluster.
TEST(UniformCut, LeavesApartWhatIsLighterApart) {
  FootprintTable two;
  two.add({{test::rectangle(0, 0, 10, 10), {}}}, 0, 5);
  two.add({{test::rectangle(10, 4, 10, 10), {}}}, 0, 60);
  const ClusterTree tree = treeOf(std::move(two));
  ASSERT_EQ(tree.nodes[2].faces.polygons, 10U) << "a hull of six edges, against six polygons a house";
  ASSERT_LE(emptiness(tree.nodes[2]), 20);
  EXPECT_EQ(makeUniformCut(tree, {100, 2}, 20).drawn.size(), 2U);
  EXPECT_EQ(makeUniformCut(tree, {100, 2}, 200).drawn.size(), 1U) << "no landmark: the cluster is lighter";
}

// The hull of two far houses is a thin wall between them: next to no area, and it is seen from everywhere.
TEST(UniformCut, DoesNotBridgeWhatIsFarApart) {
  FootprintTable far;
  far.add({{test::rectangle(0, 0, 10, 10), {}}}, 0, 8);
  far.add({{test::rectangle(700, 3, 10, 10), {}}}, 0, 8);
  ClusterTree tree = treeOf(std::move(far));
  EXPECT_NEAR(tree.nodes[2].gap, 690, 1e-9);
  tree.nodes[2].negative = 700;  // as of a bridge that is a metre wide
  EXPECT_NEAR(emptiness(tree.nodes[2]), std::sqrt(690 * 8.0), 1e-9);
  EXPECT_EQ(makeUniformCut(tree, {100, 2}, 40).drawn.size(), 2U);
  EXPECT_EQ(makeUniformCut(tree, {100, 2}, 80).drawn.size(), 1U);
}

class UniformCutOfRealTowns : public testing::TestWithParam<const char*> {};

TEST_P(UniformCutOfRealTowns, IsTheReferencesAndNeverHeavier) {
  const auto path = test::sharedData(GetParam());
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  const Result<CityModel> city = importCity({path}, {});
  ASSERT_TRUE(city.ok());
  const ClusterTree tree = treeOf(footprintTable(*city));
  expectAsReference(tree);
  expectLighterAndLighter(tree);
}

INSTANTIATE_TEST_SUITE_P(Shared, UniformCutOfRealTowns,
                         testing::Values("C_footprints/suzhou_pybdshadow/bd_demo.json",
                                         "A_citygml/nrw_lod2/LoD2_32_280_5657_1_NW.gml",
                                         "B_cityjson/cjio/zurich/zurich_subset_lod2.json"));

}  // namespace
}  // namespace lodestone
