#include "algorithms/chains/chain_building.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "algorithms/clustering/clustering.h"
#include "algorithms/merging/cutting.h"
#include "algorithms/merging/merging.h"
#include "algorithms/synthesis/synthesis.h"

namespace lodestone {
namespace {

struct Town {
  std::shared_ptr<const CityModel> city;
  std::shared_ptr<const ClusterTree> tree;
};

const Town& town() {
  static const Town result = [] {
    Town made;
    made.city = std::make_shared<const CityModel>(synthesiseCity({}));
    auto footprints = std::make_shared<const FootprintTable>(footprintTable(*made.city));
    auto dendrogram = std::make_shared<const Dendrogram>(makeDendrogram(*footprints, {}));
    made.tree = std::make_shared<const ClusterTree>(makeClusterTree(footprints, dendrogram));
    return made;
  }();
  return result;
}

/// Every building has one cluster or building of the level that stands for it; landmarks come on top.
void expectCovers(const LodLevel& level, const CityModel& city) {
  std::vector<int> covered(city.buildings.size(), 0);
  for (std::size_t i = 0; i < level.objectCount; ++i) {
    const LevelObject object = level.object(i);
    EXPECT_TRUE(std::is_sorted(object.buildings.begin(), object.buildings.end()));
    if (object.role == DrawRole::Landmark) continue;
    for (std::uint32_t building : object.buildings) ++covered[building];
  }
  for (int count : covered) EXPECT_EQ(count, 1);
}

TEST(Chain, LevelsAreCoarserAndCoarserAndCoverTheCity) {
  const Result<LodChain> chain = makeChain(town().city, town().tree, {});
  ASSERT_TRUE(chain.ok());
  ASSERT_EQ(chain->levels.size(), 5U);
  EXPECT_EQ(chain->levels[2].name, "legible-10m");
  for (std::size_t i = 0; i < chain->levels.size(); ++i) {
    const LodLevel& level = chain->levels[i];
    SCOPED_TRACE(level.name);
    expectCovers(level, *town().city);
    if (i == 0) continue;
    EXPECT_GE(level.error, chain->levels[i - 1].error);
    EXPECT_GT(level.switchDistance, chain->levels[i - 1].switchDistance);
    EXPECT_LE(level.faces.polygons, chain->levels[i - 1].faces.polygons);
  }
  EXPECT_LT(chain->levels[4].faces.polygons, chain->levels[0].faces.polygons);
}

TEST(Chain, OptionsOfTheCutAreThoseOfTheCut) {
  const auto& ofChains = fields<ChainOptions>();
  for (const Field<CutOptions>& row : fields<CutOptions>()) {
    const auto same = std::find_if(ofChains.begin(), ofChains.end(),
                                   [&](const Field<ChainOptions>& field) { return field.name == row.name; });
    ASSERT_NE(same, ofChains.end());
    EXPECT_EQ(same->min, row.min);
    EXPECT_EQ(same->max, row.max);
    ChainOptions options;
    same->set(options, FieldValue(7.5));
    EXPECT_EQ(row.get(options.cut), FieldValue(7.5));
    EXPECT_EQ(same->get(options), FieldValue(7.5));
  }
}

// What the live cut takes, a chain takes: nothing empty may be seen, so no level ever takes over.
TEST(Chain, WithoutToleranceOnScreenNoLevelTakesOver) {
  const Result<LodChain> chain = makeChain(town().city, town().tree, {.cut = {.epsilon = 0}});
  ASSERT_TRUE(chain.ok());
  ASSERT_EQ(chain->levels.size(), 5U);
  for (std::size_t i = 1; i < chain->levels.size(); ++i) {
    EXPECT_TRUE(std::isinf(chain->levels[i].switchDistance));
    expectCovers(chain->levels[i], *town().city);
  }
}

FaceCount facesOf(const LodLevel& level) {
  FaceCount sum;
  for (std::size_t i = 0; i < level.objectCount; ++i) {
    for (const Geometry& geometry : level.object(i).geometries) sum += facesOf(geometry);
  }
  return sum;
}

std::size_t trianglesOf(const LodLevel& level) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < level.objectCount; ++i) {
    for (const auto& triangles : level.object(i).triangles) sum += triangles.size();
  }
  return sum;
}

// One count for all: what a level says, what its objects are made of, what the same cut says, and what the
// tree takes for all buildings.
TEST(Chain, FacesAreThoseOfItsObjectsAndOfTheSameCut) {
  const Result<LodChain> chain = makeChain(town().city, town().tree, {});
  ASSERT_TRUE(chain.ok());
  EXPECT_EQ(chain->levels[0].faces, town().tree->buildingFaces);
  const std::array tolerances{0.0, 5.0, 10.0, 20.0, 40.0};
  for (std::size_t i = 0; i < chain->levels.size(); ++i) {
    const LodLevel& level = chain->levels[i];
    SCOPED_TRACE(level.name);
    EXPECT_EQ(level.faces, facesOf(level));
    EXPECT_EQ(level.faces.triangles, trianglesOf(level));
    if (i > 0) {
      EXPECT_EQ(level.faces, makeUniformCut(*town().tree, {}, tolerances[i]).faces);
    }
  }
  Camera camera;
  camera.eye = Vec3(-300, -300, 200);
  const Cut cut = makeCut(*town().tree, {}, camera);
  EXPECT_EQ(cut.faces, facesOf(levelOfCut(town().city, town().tree, cut)));
}

TEST(Chain, OriginalIsEachBuildingWithItsId) {
  const Result<LodChain> chain = makeChain(town().city, nullptr, {});
  ASSERT_TRUE(chain.ok());
  ASSERT_EQ(chain->levels.size(), 1U);
  const LodLevel& level = chain->levels[0];
  EXPECT_EQ(level.error, 0);
  ASSERT_EQ(level.objectCount, town().city->buildings.size());
  for (std::size_t i = 0; i < level.objectCount; ++i) {
    const LevelObject object = level.object(i);
    EXPECT_EQ(object.id, town().city->buildings[i].object.id);
    EXPECT_EQ(object.role, DrawRole::Building);
    ASSERT_FALSE(object.geometries.empty());
    ASSERT_EQ(object.triangles.size(), object.geometries.size());
    EXPECT_FALSE(object.triangles[0].empty());
  }
}

TEST(Chain, ErrorIsThatOfTheWorstBuildingItSwallows) {
  const Result<LodChain> chain = makeChain(town().city, town().tree, {.tolerances = "10"});
  ASSERT_TRUE(chain.ok());
  const LodLevel& level = chain->levels[1];
  std::vector<bool> shown(town().city->buildings.size());
  for (std::size_t i = 0; i < level.objectCount; ++i) {
    const LevelObject object = level.object(i);
    if (object.role == DrawRole::Landmark) shown[object.buildings[0]] = true;
  }
  double worst = 0;
  for (std::size_t i = 0; i < level.objectCount; ++i) {
    const LevelObject object = level.object(i);
    if (object.role != DrawRole::Cluster) continue;
    EXPECT_EQ(object.id, "cluster-" + std::to_string(object.node));
    const double empty = emptiness(town().tree->nodes[object.node]);
    EXPECT_LE(empty, 10);
    worst = std::max(worst, empty);
    for (std::uint32_t b : object.buildings) {
      const Building& building = town().city->buildings[b];
      if (!shown[b])
        worst = std::max(worst, std::abs(building.base + building.height - object.base - object.height));
    }
  }
  EXPECT_NEAR(level.error, worst, 1e-9);
}

TEST(Chain, OfACutDrawsWhatTheCutDraws) {
  Camera camera;
  camera.eye = Vec3(-300, -300, 200);
  const Cut cut = makeCut(*town().tree, {}, camera);
  const LodLevel level = levelOfCut(town().city, town().tree, cut);
  ASSERT_EQ(level.objectCount, cut.drawn.size());
  for (std::size_t i = 0; i < level.objectCount; ++i) {
    const LevelObject object = level.object(i);
    EXPECT_EQ(object.node, cut.drawn[i].node);
    EXPECT_EQ(object.role, cut.drawn[i].role);
    EXPECT_EQ(object.of, cut.drawn[i].of);
  }
}

TEST(Chain, RecipeMakesItAgain) {
  const Result<LodChain> chain =
      makeChain(town().city, town().tree, {.tolerances = "2.5,20", .cut = {.alpha = 3}});
  ASSERT_TRUE(chain.ok());
  const Result<Recipe> recipe = parseRecipe(chain->recipe);
  ASSERT_TRUE(recipe.ok());
  const Result<ChainPlan> plan = planOf(*recipe);
  ASSERT_TRUE(plan.ok());
  EXPECT_EQ(plan->chain, (ChainOptions{.tolerances = "2.5,20", .cut = {.alpha = 3}}));
  EXPECT_EQ(plan->cluster, town().tree->dendrogram->options);
  EXPECT_EQ(plan->merge, town().tree->options);
  const Result<LodChain> again = makeChain(town().city, town().tree, plan->chain);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->recipe, chain->recipe);
}

TEST(Chain, PlanSaysWhatItDoesNotKnow) {
  Recipe recipe;
  recipe.levels = {
      {"original", {}}, {"magic", {}}, {"legible", {{"tolerance", 5.0}, {"colour", std::string("red")}}}};
  const Result<ChainPlan> plan = planOf(recipe);
  EXPECT_FALSE(plan.ok());
  ASSERT_EQ(plan.diagnostics.size(), 2U);
  EXPECT_EQ(plan.diagnostics[0].code, Code::OptionBadValue);
  EXPECT_EQ(plan.diagnostics[1].code, Code::OptionUnknown);
}

TEST(Chain, ALevelThatIsNoLighterIsSaid) {
  const Result<LodChain> chain = makeChain(town().city, town().tree, {.tolerances = "10,10.000001"});
  ASSERT_TRUE(chain.ok());
  ASSERT_EQ(chain.diagnostics.size(), 1U);
  EXPECT_EQ(chain.diagnostics[0].code, Code::LevelNotLighter);
  EXPECT_NE(chain.diagnostics[0].text.find("legible-10.000001m: 100.0% of legible-10m"), std::string::npos);
}

TEST(Chain, TolerancesMustRise) {
  for (const char* bad : {"5,4", "5,5", "0", "-1", "a", "5,,6", "nan"}) {
    const Result<LodChain> chain = makeChain(town().city, town().tree, {.tolerances = bad});
    EXPECT_FALSE(chain.ok()) << bad;
    ASSERT_FALSE(chain.diagnostics.empty());
    EXPECT_EQ(chain.diagnostics[0].code, Code::OptionBadValue);
  }
  EXPECT_EQ(makeChain(town().city, town().tree, {.tolerances = ""})->levels.size(), 1U);
}

TEST(SimplifiedChain, NamesHowItWasLookedAtWhereTheMethodAsks) {
  const auto names = [](SimplifyMethod method) {
    PerceiveOptions perceive;
    perceive.views = 3;
    std::map<std::string, FieldValue> named;
    const LodChain chain =
        simplifiedChain(std::make_shared<const CityModel>(), {.method = method}, 0, perceive);
    for (const auto& [name, value] : chain.levels.front().options) named.emplace(name, value);
    return named;
  };
  EXPECT_EQ(names(SimplifyMethod::Combined).at("views"), FieldValue(std::int64_t{3}));
  EXPECT_EQ(names(SimplifyMethod::Perception).count("distance"), 1U);
  EXPECT_EQ(names(SimplifyMethod::Topology).count("views"), 0U);
}

}  // namespace
}  // namespace lodestone
