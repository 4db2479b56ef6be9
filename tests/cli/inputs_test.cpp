// What the program says of its inputs.
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/cli/cli_support.h"

namespace lodestone::test {
namespace {

using testing::HasSubstr;

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

TEST(Cli, InfoOfAMeshNamesNoCode) {
  const TemporaryFolder folder;
  const std::string input = (folder / "slab.obj").string();
  writeText(input, "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n");
  const Outcome outcome = cli({"info", input});
  EXPECT_THAT(outcome.out, HasSubstr("its own: metres"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("EPSG")));
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

}  // namespace
}  // namespace lodestone::test
