#include "model/io/recipe.h"

#include <filesystem>
#include <fstream>

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

TEST(Recipe, NamesFilesFromItsOwnFolder) {
  namespace fs = std::filesystem;
  const fs::path home = fs::path(::testing::TempDir()) / "recipe_test";
  fs::create_directories(home / "data/deep");
  fs::create_directories(home / "chain");
  Recipe recipe = sample();
  recipe.sources = {(home / "data/deep/../town.gml").string(), (home / "chain/beside.gml").string()};
  recipe.barriers = {fs::relative(home / "data/streets.geojson").string()};
  const std::string text = recipeText(recipe, home / "chain");
  EXPECT_NE(text.find("\"../data/town.gml\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"beside.gml\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"../data/streets.geojson\""), std::string::npos) << text;

  std::ofstream(home / "chain/recipe.json") << text;
  const fs::path here = fs::current_path();
  fs::current_path("/");
  const Result<Recipe> read = loadRecipe(home / "chain/recipe.json");
  fs::current_path(here);
  ASSERT_TRUE(read.ok());
  const fs::path canonical = fs::canonical(home);
  EXPECT_EQ(read->sources, (std::vector<std::string>{(canonical / "data/town.gml").string(),
                                                     (canonical / "chain/beside.gml").string()}));
  EXPECT_EQ(read->barriers, std::vector<std::string>{(canonical / "data/streets.geojson").string()});
}

// A link's own name names the outputs; the folders on the way are the true ones.
TEST(Recipe, KeepsTheNamesOfLinks) {
  namespace fs = std::filesystem;
  const fs::path home = fs::path(::testing::TempDir()) / "recipe_links";
  fs::remove_all(home);
  fs::create_directories(home / "data");
  std::ofstream(home / "data/v1.gml") << "x";
  fs::create_symlink("v1.gml", home / "data/town.gml");
  fs::create_directory_symlink("data", home / "link");
  Recipe recipe = sample();
  recipe.sources = {(home / "link/town.gml").string()};
  recipe.barriers.clear();
  EXPECT_NE(recipeText(recipe, home / "chain").find("\"../data/town.gml\""), std::string::npos);
}

TEST(Recipe, ThatIsNotThereIsSaid) {
  const Result<Recipe> read = loadRecipe(std::filesystem::path(::testing::TempDir()) / "no_recipe.json");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.diagnostics.at(0).code, Code::FileNotFound);
}

TEST(Recipe, OfALaterVersionIsReadAndSaid) {
  const Result<Recipe> read = parseRecipe(R"({"type":"recipe","version":2,"levels":[]})");
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_EQ(read.diagnostics[0].code, Code::VersionUnsupported);
}

}  // namespace
}  // namespace lodestone
