// The command line as users meet it: the built program, its files and its exit status.
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include <gmock/gmock.h>

#include "tests/cli/cli_support.h"

namespace lodestone::test {
namespace {

using testing::HasSubstr;

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

TEST(Cli, RenderNeedsNoDisplay) {
  const TemporaryFolder folder;
  const std::string input = town(folder, 30);
  const Outcome outcome = cli({"render", input, "-o", (folder / "p.png").string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(readText(folder / "p.png").substr(1, 3), "PNG");
}

}  // namespace
}  // namespace lodestone::test
