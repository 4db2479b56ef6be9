#include "model/io/recipe.h"

#include <gtest/gtest.h>

namespace lodestone {
namespace {

Recipe sample() {
  Recipe recipe;
  recipe.sources = {"a.gml", "dir/b \"quoted\".json"};
  recipe.levels.push_back({"original", {}});
  recipe.levels.push_back({"legible",
                           {{"tolerance", 2.5},
                            {"neighbours", std::int64_t{50}},
                            {"linkage", std::string("legible")},
                            {"x", true}}});
  recipe.exports = {"glb", "cityjson"};
  return recipe;
}

TEST(Recipe, ComesBackAsItWas) {
  const Result<Recipe> read = parseRecipe(recipeText(sample()));
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(read.diagnostics.empty());
  EXPECT_EQ(*read, sample());
}

TEST(Recipe, OfAChainNamesSourcesAndLevels) {
  auto city = std::make_shared<CityModel>();
  city->sources.push_back({"town.gml", "citygml", "2.0", ""});
  LodChain chain{city, nullptr, {}, {}};
  LodLevel level;
  level.method = "legible";
  level.options = {{"tolerance", 5.0}};
  chain.levels = {level};
  const Recipe recipe = recipeOf(chain, {"obj"});
  EXPECT_EQ(recipe.sources, std::vector<std::string>{"town.gml"});
  ASSERT_EQ(recipe.levels.size(), 1U);
  EXPECT_EQ(recipe.levels[0].options, level.options);
  EXPECT_EQ(recipe.exports, std::vector<std::string>{"obj"});
}

TEST(Recipe, RefusesWhatIsNotOne) {
  for (const char* text :
       {"", "{", "[]", "{}", R"({"type":"cut","version":1,"levels":[]})", R"({"type":"recipe","version":1})",
        R"({"type":"recipe","version":1,"levels":[1]})",
        R"({"type":"recipe","version":1,"levels":[{"method":3}]})",
        R"({"type":"recipe","version":1,"levels":[{"method":"legible","options":[]}]})",
        R"({"type":"recipe","version":1,"levels":[],"source":"a"})",
        R"({"type":"recipe","version":1,"levels":[],"exports":[1]})"}) {
    const Result<Recipe> read = parseRecipe(text);
    EXPECT_FALSE(read.ok()) << text;
    ASSERT_EQ(read.diagnostics.size(), 1U) << text;
    EXPECT_EQ(read.diagnostics[0].code, Code::FileMalformed) << text;
  }
}

TEST(Recipe, OfALaterVersionIsReadAndSaid) {
  const Result<Recipe> read = parseRecipe(R"({"type":"recipe","version":2,"levels":[]})");
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_EQ(read.diagnostics[0].code, Code::VersionUnsupported);
}

}  // namespace
}  // namespace lodestone
