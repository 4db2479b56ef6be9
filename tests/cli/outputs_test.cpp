// What the program writes, and what it leaves alone.
#include <set>

#include <gmock/gmock.h>

#include "tests/cli/cli_support.h"

namespace lodestone::test {
namespace {

using testing::HasSubstr;

TEST(Cli, TolerancesAreCheckedBeforeAnythingIsRead) {
  const TemporaryFolder folder;
  for (const char* tolerances : {"20,10", "0", "5;10"}) {
    const Outcome outcome =
        cli({"chain", "nowhere.gml", "--tolerances", tolerances, "-o", (folder / "chain").string()});
    EXPECT_EQ(outcome.status, 2) << tolerances;
    EXPECT_THAT(outcome.err, HasSubstr("rising"));
  }
}

TEST(Cli, NothingOfOthersIsReplaced) {
  const TemporaryFolder folder;
  const std::string input = town(folder, 20);
  const std::string before = readText(input);
  const Outcome same = cli({"convert", input, "-o", input});
  EXPECT_EQ(same.status, 1);
  EXPECT_THAT(same.err, HasSubstr("error 701"));
  EXPECT_EQ(readText(input), before);

  std::filesystem::create_directory(folder / "mine");
  writeText(folder / "mine/recipe.json", "flour, eggs");
  const Outcome foreign = cli({"chain", input, "-o", (folder / "mine").string(), "--formats", "geojson"});
  EXPECT_EQ(foreign.status, 1);
  EXPECT_THAT(foreign.err, HasSubstr("error 701"));
  EXPECT_EQ(filesIn(folder / "mine"), std::set<std::string>{"recipe.json"});

  // A new folder, an empty one, and that of a chain.
  std::filesystem::create_directory(folder / "empty");
  for (const std::string name : {"new", "empty", "new"}) {
    const Outcome outcome = cli({"chain", input, "-o", (folder / name).string(), "--formats", "geojson"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
}

TEST(Cli, FilesOfAnEarlierChainAreNamed) {
  const TemporaryFolder folder;
  const std::string input = town(folder, 20);
  const std::string output = (folder / "chain").string();
  const Outcome first = cli({"chain", input, "-o", output, "--formats", "geojson,obj"});
  EXPECT_THAT(first.err, testing::Not(HasSubstr("708")));
  const Outcome again = cli({"chain", input, "-o", output, "--formats", "geojson,obj"});
  EXPECT_THAT(again.err, testing::Not(HasSubstr("708")));
  const Outcome other = cli({"chain", input, "-o", output, "--formats", "gpkg"});
  EXPECT_EQ(other.status, 0);
  EXPECT_THAT(other.err, HasSubstr("note 708"));
  EXPECT_THAT(other.err, HasSubstr("obj/town_level-0.mtl and 15 more"));
}

// What the help says is written is written, and the rest is refused before any work.
TEST(Cli, HelpAndWritersAgreeOnEndings) {
  const TemporaryFolder folder;
  const std::string input = town(folder, 20);
  const std::string help = cli({"merge", "--help"}).out;
  for (const std::string ending : {".geojson", ".json", ".gpkg", ".shp", ".fgb", ".gml", ".kml"}) {
    EXPECT_THAT(help, HasSubstr(ending));
    const Outcome outcome = cli({"merge", input, "-o", (folder / ("hulls" + ending)).string()});
    EXPECT_EQ(outcome.status, 0) << ending << outcome.err;
  }
  const std::string pictures = cli({"render", "--help"}).out;
  for (const std::string ending : {".png", ".jpg", ".tif", ".webp", ".bmp"}) {
    EXPECT_THAT(pictures, HasSubstr(ending));
    const Outcome outcome = cli({"render", input, "--original", "--camera", "0,0,9,5,5,0,45,20x10", "-o",
                                 (folder / ("picture" + ending)).string()});
    EXPECT_EQ(outcome.status, 0) << ending << outcome.err;
  }
  for (const std::string command : {"merge", "render"}) {
    const Outcome outcome = cli({command, input, "-o", (folder / "x.csv").string()});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr(command == "merge" ? ".fgb" : ".webp"));
  }
}

TEST(Cli, UnknownOutputEndingIsTwo) {
  const TemporaryFolder folder;
  const Outcome outcome = cli({"synth", "-o", (folder / "town.docx").string()});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("error 704"));
}

TEST(Cli, AChainIsMadeAgainFromItsRecipeByteForByte) {
  const TemporaryFolder folder;
  const std::string input = town(folder);
  const Outcome first = cli({"chain", input, "-o", (folder / "one").string(), "--formats",
                             "cityjson,glb,obj,geojson,gpkg", "--tolerances", "4,16"});
  ASSERT_EQ(first.status, 0) << first.err;
  ASSERT_TRUE(std::filesystem::exists(folder / "one/recipe.json"));
  const Outcome second = cli(
      {"chain", input, "-o", (folder / "two").string(), "--recipe", (folder / "one/recipe.json").string()});
  ASSERT_EQ(second.status, 0) << second.err;
  const auto files = filesIn(folder / "one");
  EXPECT_EQ(files, filesIn(folder / "two"));
  EXPECT_GE(files.size(), 6U);
  for (const std::string& name : files)
    EXPECT_EQ(readText(folder / ("one/" + name)), readText(folder / ("two/" + name))) << name;
}

TEST(Cli, ARecipeHoldsFromAnyFolder) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const std::string input = town(folder, 40);
  const Json extent = Json::parse(cli({"info", input, "--json"}).out)["extent"];
  const Json street = {{"type", "LineString"}, {"coordinates", {extent["min"], extent["max"]}}};
  writeText(folder / "street.geojson",
            Json{{"type", "Feature"},
                 {"properties", Json::object()},
                 {"geometry", street},
                 {"crs", {{"type", "name"}, {"properties", {{"name", "urn:ogc:def:crs:EPSG::25832"}}}}}}
                .dump());
  const fs::path here = fs::current_path();
  fs::current_path(folder.path());
  const Outcome first = cli({"chain", "town.city.json", "--barriers", "street.geojson", "-o", "one",
                             "--formats", "cityjson,glb,obj,geojson,gpkg"});
  fs::create_directory("elsewhere");
  fs::current_path("elsewhere");
  const Outcome second = cli({"chain", "-o", "../two", "--recipe", "../one/recipe.json"});
  fs::current_path(here);
  ASSERT_NE(first.status, 1) << first.err;
  ASSERT_EQ(second.status, first.status) << second.err;
  const auto files = filesIn(folder / "one");
  EXPECT_EQ(files, filesIn(folder / "two"));
  for (const std::string& name : files)
    EXPECT_EQ(readText(folder / ("one/" + name)), readText(folder / ("two/" + name))) << name;
  EXPECT_EQ(jsonOf(folder / "one/recipe.json")["source"], Json::array({"../town.city.json"}));
}

TEST(Cli, AMissingRecipeIsNamed) {
  const TemporaryFolder folder;
  const Outcome outcome =
      cli({"chain", "-o", (folder / "c").string(), "--recipe", (folder / "none.json").string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("error 101"));
}

TEST(Cli, AnInterruptLeavesTheOldFile) {
  const TemporaryFolder folder;
  writeText(folder / "big.city.json", "old");
  const Outcome outcome = cli(
      {"synth", "--preset", "charlotte", "--buildings", "3000000", "-o", (folder / "big.city.json").string()},
      700);
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_EQ(readText(folder / "big.city.json"), "old");
  EXPECT_EQ(filesIn(folder.path()).size(), 1U);
}

}  // namespace
}  // namespace lodestone::test
