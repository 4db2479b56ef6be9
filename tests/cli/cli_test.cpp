// The command line as users meet it: the built program, its files and its exit status.
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace lodestone::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

Outcome cli(std::vector<std::string> arguments, int interruptAfter = 0) {
  arguments.insert(arguments.begin(), LODESTONE_CLI);
  return runProgram(arguments, interruptAfter);
}

Json jsonOf(const std::filesystem::path& path) {
  return Json::parse(readText(path));
}

std::set<std::string> filesIn(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      names.insert(std::filesystem::relative(entry.path(), folder).generic_string());
  }
  return names;
}

/// A made-up town of a few buildings.
std::string town(const TemporaryFolder& folder, int buildings = 120) {
  const std::string path = (folder / "town.city.json").string();
  const Outcome outcome = cli({"synth", "-o", path, "--buildings", std::to_string(buildings)});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return path;
}

TEST(Cli, HelpAndVersionNeedNothing) {
  EXPECT_EQ(cli({"--version"}).status, 0);
  const Outcome help = cli({"cluster", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, HasSubstr("1 to 1000 buildings"));
  EXPECT_THAT(help.out, HasSubstr("default 50"));
}

TEST(Cli, WrongUsageIsTwo) {
  EXPECT_EQ(cli({}).status, 2);
  EXPECT_EQ(cli({"paint"}).status, 2);
  EXPECT_EQ(cli({"cluster", "x.gml"}).status, 2);
  EXPECT_EQ(cli({"cluster", "x.gml", "-o", "d.json", "--neighbours", "0"}).status, 2);
  EXPECT_EQ(cli({"cluster", "x.gml", "-o", "d.json", "--linkage", "nearest"}).status, 2);
}

TEST(Cli, ASystemThatIsNoneIsWrongUsage) {
  const TemporaryFolder folder;
  const std::string input = town(folder, 20);
  for (const std::string crs : {"EPSG:99999999", "nonsense"}) {
    const Outcome outcome = cli({"convert", input, "--crs", crs, "-o", (folder / "out.geojson").string()});
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("crs is " + crs + ", wanted EPSG:N"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out.geojson"));
  }
}

// Nobody gets 10 m for "hoch" without a word.
TEST(Cli, HeightsThatAreNoneAreNamed) {
  const TemporaryFolder folder;
  Json features = Json::array();
  const std::vector<Json> heights{"hoch", "12;14", "12 m", "12,5", 7, nullptr};
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double x = 400000 + 50.0 * static_cast<double>(i);
    const Json ring{{x, 5800000}, {x + 10, 5800000}, {x + 10, 5800010}, {x, 5800000}};
    features.push_back({{"type", "Feature"},
                        {"id", fmt::format("house-{}", i)},
                        {"properties", {{"height", heights[i]}, {"levels", i == 1 ? Json("3") : Json()}}},
                        {"geometry", {{"type", "Polygon"}, {"coordinates", {ring}}}}});
  }
  const std::string input = (folder / "town.geojson").string();
  writeText(input, Json{{"type", "FeatureCollection"}, {"features", features}}.dump());
  const Outcome outcome = cli({"info", input, "--crs", "EPSG:25833", "--json"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.err,
              HasSubstr("warning 221 [house-0]: height or floors not understood: height \"hoch\""));
  EXPECT_THAT(outcome.err, HasSubstr("[house-1]: height or floors not understood: height \"12;14\""));
  EXPECT_EQ(Json::parse(outcome.out)["heights"], Json({{"default", 2}, {"field", 3}, {"floors", 1}}));
}

TEST(Cli, TolerancesAreCheckedBeforeAnythingIsRead) {
  const TemporaryFolder folder;
  for (const char* tolerances : {"20,10", "0", "5;10"}) {
    const Outcome outcome =
        cli({"chain", "nowhere.gml", "--tolerances", tolerances, "-o", (folder / "chain").string()});
    EXPECT_EQ(outcome.status, 2) << tolerances;
    EXPECT_THAT(outcome.err, HasSubstr("rising"));
  }
}

TEST(Cli, InfoOfAMeshNamesNoCode) {
  const TemporaryFolder folder;
  const std::string input = (folder / "slab.obj").string();
  writeText(input, "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n");
  const Outcome outcome = cli({"info", input});
  EXPECT_THAT(outcome.out, HasSubstr("its own: metres"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("EPSG")));
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

TEST(Cli, FitLeavesStraysOut) {
  const TemporaryFolder folder;
  Json features = Json::array();
  const auto add = [&](double x, double y) {
    const Json ring{{x, y}, {x + 10, y}, {x + 10, y + 10}, {x, y}};
    features.push_back({{"type", "Feature"},
                        {"properties", {{"height", 9}}},
                        {"geometry", {{"type", "Polygon"}, {"coordinates", {ring}}}}});
  };
  for (int i = 0; i < 60; ++i) add(400000 + 20 * (i % 8), 5800000 + 20 * (i / 8));
  add(430000, 5830000);
  const std::string input = (folder / "town.geojson").string();
  writeText(input, Json{{"type", "FeatureCollection"}, {"features", features}}.dump());
  const Outcome outcome =
      cli({"cut", input, "--crs", "EPSG:25833", "--camera", "fit:ne", "-o", (folder / "cut.json").string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json eye = jsonOf(folder / "cut.json")["camera"]["eye"];
  EXPECT_LT(std::hypot(eye[0].get<double>() - 400000, eye[1].get<double>() - 5800000), 1000);
  EXPECT_THAT(cli({"cut", "--help"}).out, HasSubstr("fit[:n|ne|e|se|s|sw|w|nw|top]"));
}

TEST(Cli, MissingInputIsOneAndWritesNothing) {
  const TemporaryFolder folder;
  const Outcome outcome =
      cli({"cluster", (folder / "none.gml").string(), "-o", (folder / "d.json").string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("error 101"));
  EXPECT_TRUE(filesIn(folder.path()).empty());
}

// What the user named must all be there: a result without one input would be taken for the whole.
TEST(Cli, OneUnreadableInputOfSeveralIsOneAndWritesNothing) {
  const TemporaryFolder folder;
  const std::string good = town(folder);
  const std::string output = (folder / "out.city.json").string();
  std::ofstream(folder / "cut.city.json") << R"({"type":"CityJSON","version")";
  std::ofstream(folder / "noise.bin") << "neither this nor that";
  const std::map<std::string, std::string> bad{
      {"none.gml", "error 101"}, {"cut.city.json", "error 104"}, {"noise.bin", "error 103"}};
  for (const auto& [name, message] : bad) {
    const Outcome outcome = cli({"convert", good, (folder / name).string(), "-o", output});
    EXPECT_EQ(outcome.status, 1) << name;
    EXPECT_THAT(outcome.err, HasSubstr(message)) << name;
    EXPECT_FALSE(std::filesystem::exists(output)) << name;
  }
}

/// A house of 20 units, 9 m high, as CityJSON in `crs` (a code, or 0).
std::string houseAt(const TemporaryFolder& folder, const std::string& name, double x, double y, int crs,
                    double unit = 1) {
  const Json house = {
      {"type", "Building"},
      {"geometry",
       {{{"type", "MultiSurface"}, {"lod", "1"}, {"boundaries", {{{0, 3, 2, 1}}, {{4, 5, 6, 7}}}}}}}};
  Json city{
      {"type", "CityJSON"},
      {"version", "2.0"},
      {"transform", {{"scale", {unit, unit, 1}}, {"translate", {x, y, 0}}}},
      {"CityObjects", {{"house", house}}},
      {"vertices",
       {{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}, {0, 0, 9}, {20, 0, 9}, {20, 20, 9}, {0, 20, 9}}}};
  if (crs != 0)
    city["metadata"] = {{"referenceSystem", fmt::format("https://www.opengis.net/def/crs/EPSG/0/{}", crs)}};
  const std::string path = (folder / name).string();
  std::ofstream(path) << city.dump();
  return path;
}

TEST(Cli, ASystemThatNoCoordinateFitsGivesNoChain) {
  const TemporaryFolder folder;
  const std::string input = houseAt(folder, "house.city.json", 370000, 5808000, 0);
  const Outcome outcome = cli({"chain", input, "--crs", "EPSG:4326", "-o", (folder / "chain").string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("404"));
  EXPECT_EQ(filesIn(folder.path()), std::set<std::string>{"house.city.json"});
}

TEST(Cli, AFileWithoutASystemBesideGeographicOnesIsOneAndWritesNothing) {
  const TemporaryFolder folder;
  const std::string known = houseAt(folder, "known.city.json", 52.5, 13.4, 4326, 1e-5);
  const std::string stranger = houseAt(folder, "stranger.city.json", 390000, 5820000, 0);
  const std::string output = (folder / "out.city.json").string();
  const Outcome outcome = cli({"convert", known, stranger, "-o", output});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("error 404"));
  EXPECT_THAT(outcome.err, HasSubstr("error 124"));
  EXPECT_FALSE(std::filesystem::exists(output));
}

// EPSG:3857's metres are none on the ground, EPSG:2263 is in feet: what goes in and out is in them still.
TEST(Cli, SpeaksInTheInputsCoordinates) {
  struct Place {
    int crs;
    double x;
    double y;
  };
  for (const auto& [crs, x, y] : {Place{3857, 1491000, 6894000}, Place{2263, 985000, 210000}}) {
    const TemporaryFolder folder;
    const std::string input = houseAt(folder, "house.city.json", x, y, crs);
    const Outcome info = cli({"info", input, "--json"});
    ASSERT_EQ(info.status, 0) << info.err;
    const Json json = Json::parse(info.out);
    EXPECT_EQ(json["crs"]["epsg"], crs);
    EXPECT_NEAR(json["extent"]["min"][0].get<double>(), x, 1e-3);
    EXPECT_NEAR(json["extent"]["max"][1].get<double>(), y + 20, 1e-3);

    const std::string back = (folder / "back.city.json").string();
    ASSERT_EQ(cli({"convert", input, "-o", back}).status, 0);
    EXPECT_EQ(jsonOf(back)["metadata"]["referenceSystem"], jsonOf(input)["metadata"]["referenceSystem"]);
    const Json again = Json::parse(cli({"info", back, "--json"}).out);
    EXPECT_NEAR(again["extent"]["min"][0].get<double>(), x, 2e-3);

    const std::string outline = (folder / "outline.geojson").string();
    ASSERT_EQ(cli({"convert", input, "-o", outline}).status, 0);
    EXPECT_THAT(readText(outline), HasSubstr(fmt::format("EPSG::{}", crs)));
    const Json ring = jsonOf(outline)["features"][0]["geometry"]["coordinates"][0];
    ASSERT_EQ(ring.size(), 5U);
    for (const Json& corner : ring) {
      EXPECT_NEAR(std::abs(corner[0].get<double>() - x - 10), 10, 1e-3);
      EXPECT_NEAR(std::abs(corner[1].get<double>() - y - 10), 10, 1e-3);
    }

    const std::string cut = (folder / "cut.json").string();
    const std::string camera = fmt::format("{},{},60,{},{},0", x - 60, y - 60, x + 10, y + 10);
    ASSERT_EQ(cli({"cut", input, "--camera", camera, "-o", cut}).status, 0);
    EXPECT_EQ(jsonOf(cut)["drawn"].size(), 1U);
    EXPECT_NEAR(jsonOf(cut)["camera"]["eye"][0].get<double>(), x - 60, 1e-6);
  }
}

TEST(Cli, NamesAnUnknownCommand) {
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"bogus"}, {"--threads", "2", "bogus", "x.gml"}}) {
    const Outcome outcome = cli(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr("unknown command 'bogus'"));
    EXPECT_THAT(outcome.err, HasSubstr("info, convert, synth"));
  }
}

// --quiet silences what is no trouble: progress, notes and tables.
TEST(Cli, QuietStillWarns) {
  const TemporaryFolder folder;
  std::ofstream(folder / "empty.geojson") << R"({"type":"FeatureCollection","features":[]})";
  const Outcome outcome = cli({"chain", (folder / "empty.geojson").string(), "-o",
                               (folder / "chain").string(), "--formats", "geojson", "--quiet"});
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("warning 107"));
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("note ")));
  EXPECT_EQ(outcome.out, "");
}

TEST(Cli, InfoListsTheCommonestAttributes) {
  const TemporaryFolder folder;
  const std::string place = R"("geometry":{"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,0]]]})";
  std::string many;
  for (int i = 0; i < 30; ++i) many += fmt::format(R"("tag{}":1,)", i);
  std::ofstream(folder / "tags.geojson")
      << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{)" << many
      << R"("zebra":1},)" << place << R"(},{"type":"Feature","properties":{"zebra":2},)" << place << "}]}";
  const std::string input = (folder / "tags.geojson").string();
  const Outcome text = cli({"info", input});
  EXPECT_THAT(text.out, testing::ContainsRegex("attributes +zebra \\(2\\), "));
  EXPECT_THAT(text.out, HasSubstr(" more (--json lists all)"));
  EXPECT_THAT(cli({"info", input, "--json"}).out, HasSubstr("tag29"));
}

TEST(Cli, UnknownOutputEndingIsTwo) {
  const TemporaryFolder folder;
  const Outcome outcome = cli({"synth", "-o", (folder / "town.docx").string()});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("error 704"));
}

TEST(Cli, SynthMakesTheSameBytesFromTheSameSeed) {
  const TemporaryFolder folder;
  for (const auto& [name, seed] : std::map<std::string, std::string>{{"a", "5"}, {"b", "5"}, {"c", "6"}}) {
    ASSERT_EQ(
        cli({"synth", "--buildings", "80", "--seed", seed, "-o", (folder / (name + ".city.json")).string()})
            .status,
        0);
  }
  EXPECT_EQ(readText(folder / "a.city.json"), readText(folder / "b.city.json"));
  EXPECT_NE(readText(folder / "a.city.json"), readText(folder / "c.city.json"));
}

TEST(Cli, ClusterWritesTheDocumentedShape) {
  const TemporaryFolder folder;
  const std::string input = town(folder);
  const Outcome outcome =
      cli({"cluster", input, "-o", (folder / "d.json").string(), "--report", (folder / "r.json").string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json d = jsonOf(folder / "d.json");
  EXPECT_EQ(d["type"], "dendrogram");
  EXPECT_EQ(d["linkage"], "legible");
  const std::size_t n = d["buildings"].size();
  ASSERT_EQ(d["merges"].size() + 1, n);
  std::vector<std::size_t> size(n, 1);
  std::vector<int> used(2 * n - 1, 0);
  for (const Json& merge : d["merges"]) {
    const std::size_t a = merge["a"];
    const std::size_t b = merge["b"];
    ASSERT_LT(std::max(a, b), size.size()) << "children come before their parent";
    size.push_back(size[a] + size[b]);
    EXPECT_EQ(merge["size"], size.back());
    ++used[a];
    ++used[b];
    const double w = merge["weight"];
    EXPECT_DOUBLE_EQ(w, merge["distance"].get<double>() * static_cast<double>(size[a] * size[b]));
  }
  EXPECT_EQ(size.back(), n);
  EXPECT_EQ(std::count(used.begin(), used.end(), 1), static_cast<long>(2 * n - 2));

  const Json report = jsonOf(folder / "r.json");
  EXPECT_EQ(report["command"], "cluster");
  EXPECT_EQ(report["figures"]["buildings"], n);
  EXPECT_EQ(report["figures"]["depth"], d["depth"]);
  EXPECT_GT(report["stages"][0]["peak_mib"], 0);
}

TEST(Cli, ThreadsDoNotChangeTheResult) {
  const TemporaryFolder folder;
  const std::string input = town(folder);
  for (const std::string threads : {"1", "2", "7"}) {
    ASSERT_EQ(cli({"cluster", input, "--threads", threads, "-o", (folder / ("d" + threads)).string()}).status,
              0);
    ASSERT_EQ(
        cli({"merge", input, "--threads", threads, "-o", (folder / ("h" + threads + ".geojson")).string()})
            .status,
        0);
  }
  EXPECT_EQ(readText(folder / "d1"), readText(folder / "d2"));
  EXPECT_EQ(readText(folder / "d1"), readText(folder / "d7"));
  EXPECT_EQ(jsonOf(folder / "h1.geojson")["features"], jsonOf(folder / "h7.geojson")["features"]);
}

TEST(Cli, MergeWritesAHullForEveryNode) {
  const TemporaryFolder folder;
  const std::string input = town(folder);
  ASSERT_EQ(cli({"merge", input, "-o", (folder / "h.geojson").string()}).status, 0);
  const Json features = jsonOf(folder / "h.geojson")["features"];
  std::map<long, Json> nodes;
  for (const Json& feature : features) nodes[feature["properties"]["node"].get<long>()] = feature;
  ASSERT_EQ(nodes.size() % 2, 1U);
  EXPECT_EQ(nodes.rbegin()->second["properties"]["parent"], -1);
  std::map<long, long> childEdges;
  for (const auto& [node, feature] : nodes) {
    const Json& p = feature["properties"];
    EXPECT_EQ(feature["geometry"]["coordinates"][0].size(), p["edges"].get<std::size_t>() + 1);
    EXPECT_GE(p["negative"].get<double>(), 0);
    if (p["parent"] != -1) childEdges[p["parent"].get<long>()] += p["edges"].get<long>();
  }
  for (const auto& [parent, edges] : childEdges)
    EXPECT_LE(nodes[parent]["properties"]["edges"].get<long>(), edges);
}

/// Every building has exactly one drawn or culled ancestor or self; landmarks come on top.
TEST(Cli, CutIsACut) {
  const TemporaryFolder folder;
  const std::string input = town(folder);
  ASSERT_EQ(cli({"cluster", input, "-o", (folder / "d.json").string()}).status, 0);
  const Outcome outcome =
      cli({"cut", input, "--camera", "fit:ne", "--epsilon", "400", "-o", (folder / "c.json").string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json d = jsonOf(folder / "d.json");
  const Json cut = jsonOf(folder / "c.json");
  std::map<std::size_t, std::size_t> parent;
  for (std::size_t j = 0; j < d["merges"].size(); ++j) {
    parent[d["merges"][j]["a"]] = parent[d["merges"][j]["b"]] = d["buildings"].size() + j;
  }
  std::set<std::size_t> chosen;
  std::size_t clusters = 0;
  for (const Json& drawn : cut["drawn"]) {
    if (drawn["role"] == "landmark") continue;
    EXPECT_TRUE(chosen.insert(drawn["node"].get<std::size_t>()).second);
    if (drawn["role"] == "cluster") {
      ++clusters;
      EXPECT_LE(drawn["box_pixels"].get<double>(), 400);
    }
  }
  for (const Json& culled : cut["culled"]) EXPECT_TRUE(chosen.insert(culled.get<std::size_t>()).second);
  EXPECT_GT(clusters, 0U);
  for (std::size_t building = 0; building < d["buildings"].size(); ++building) {
    int ancestors = 0;
    for (std::size_t node = building;; node = parent[node]) {
      ancestors += chosen.count(node) > 0 ? 1 : 0;
      if (!parent.count(node)) break;
    }
    EXPECT_EQ(ancestors, 1) << building;
  }
}

TEST(Cli, BadCamerasAreRefusedWithAReason) {
  const TemporaryFolder folder;
  const std::string input = town(folder, 20);
  for (const std::string camera :
       {"1,2,3", "fit:up", "0,0,0,0,0,0", "0,0,9,0,0,0,200", "0,0,9,0,0,0,45,10x", "a,b,c,d,e,f"}) {
    const Outcome outcome = cli({"cut", input, "--camera", camera, "-o", (folder / "c.json").string()});
    EXPECT_EQ(outcome.status, 2) << camera;
    EXPECT_THAT(outcome.err, HasSubstr("503")) << camera;
  }
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

TEST(Cli, RenderNeedsNoDisplay) {
  const TemporaryFolder folder;
  const std::string input = town(folder, 30);
  const Outcome outcome = cli({"render", input, "-o", (folder / "p.png").string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(readText(folder / "p.png").substr(1, 3), "PNG");
}

TEST(Cli, EmptyAndSingleInputsWork) {
  const TemporaryFolder folder;
  writeText(folder / "none.geojson", R"({"type": "FeatureCollection", "features": []})");
  writeText(folder / "one.geojson",
            R"({"type": "FeatureCollection", "features": [{"type": "Feature", "id": "solo",
    "properties": {"height": 12}, "geometry": {"type": "Polygon",
    "coordinates": [[[400000, 5800000], [400010, 5800000], [400010, 5800010], [400000, 5800010], [400000, 5800000]]]}}]})");
  for (const std::string name : {"none", "one"}) {
    const std::string input = (folder / (name + ".geojson")).string();
    const Outcome cluster =
        cli({"cluster", input, "--crs", "EPSG:25833", "-o", (folder / (name + ".json")).string()});
    EXPECT_THAT(cluster.status, testing::AnyOf(0, 3)) << cluster.err;
    const Json d = jsonOf(folder / (name + ".json"));
    EXPECT_EQ(d["buildings"].size(), name == "one" ? 1U : 0U);
    EXPECT_TRUE(d["merges"].empty());
    const Outcome chain = cli({"chain", input, "--crs", "EPSG:25833", "-o", (folder / name).string(),
                               "--formats", "cityjson,glb,obj,gpkg,geojson"});
    EXPECT_THAT(chain.status, testing::AnyOf(0, 3)) << chain.err;
  }
}

TEST(Cli, RepairedObjectsAreThreeAndListed) {
  const TemporaryFolder folder;
  writeText(folder / "bow.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "id": "good", "properties": {"height": 12}, "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]]]}},
    {"type": "Feature", "id": "bow", "properties": {"height": 12}, "geometry": {"type": "Polygon", "coordinates": [[[500, 0], [510, 10], [510, 0], [500, 10], [500, 0]]]}}]})");
  const Outcome outcome = cli({"cluster", (folder / "bow.geojson").string(), "--crs", "EPSG:25833", "-o",
                               (folder / "d.json").string(), "--report", (folder / "r.json").string()});
  EXPECT_EQ(outcome.status, 3);
  const Json report = jsonOf(folder / "r.json");
  bool listed = false;
  for (const Json& diagnostic : report["diagnostics"]) listed |= diagnostic["object"] == "bow";
  EXPECT_TRUE(listed) << outcome.err;
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
