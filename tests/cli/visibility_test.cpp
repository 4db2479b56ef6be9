// What is seen past a model and its levels, as people ask for it on the command line.
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace lodestone::test {
namespace {

using Json = nlohmann::ordered_json;
using Point = std::array<double, 3>;

/// CityJSON whose buildings have the given triangles and quads.
std::string cityOf(const std::vector<std::vector<std::vector<Point>>>& buildings) {
  Json vertices = Json::array();
  Json objects = Json::object();
  for (const auto& faces : buildings) {
    Json boundaries = Json::array();
    for (const auto& face : faces) {
      Json ring = Json::array();
      for (const Point& p : face) {
        ring.push_back(vertices.size());
        vertices.push_back({std::lround(1000 * p[0]), std::lround(1000 * p[1]), std::lround(1000 * p[2])});
      }
      boundaries.push_back(Json::array({ring}));
    }
    objects["building-" + std::to_string(objects.size())] = {
        {"type", "Building"},
        {"geometry", Json::array({{{"type", "MultiSurface"}, {"lod", "2"}, {"boundaries", boundaries}}})}};
  }
  return Json{{"type", "CityJSON"},
              {"version", "2.0"},
              {"transform", {{"scale", {0.001, 0.001, 0.001}}, {"translate", {500000, 5000000, 0}}}},
              {"metadata", {{"referenceSystem", "https://www.opengis.net/def/crs/EPSG/0/25832"}}},
              {"CityObjects", objects},
              {"vertices", vertices}}
      .dump();
}

/// The local metres of the targets are counted from elsewhere than those of the model.
TEST(Visibility, AStreetIsAsCoarseAsItIsFarWhateverTheTargetsAreCountedFrom) {
  const TemporaryFolder folder;
  std::vector<std::vector<Point>> fence;  // of fifty boards, right before the eye: one may go
  for (int i = 0; i < 50; ++i)
    fence.push_back({{0.2 * i, 0, 0}, {0.2 * i + 0.15, 0, 0}, {0.2 * i + 0.07, 0, 4}});
  writeText(folder / "fence.city.json", cityOf({fence}));
  const auto wall = [](double x) {
    return std::vector<std::vector<Point>>{{{x, 10, 0}, {x + 10, 10, 0}, {x + 10, 10, 9}, {x, 10, 9}}};
  };
  writeText(folder / "targets.city.json", cityOf({wall(0), wall(20000)}));
  const std::string answer = (folder / "answer.json").string();
  const Outcome outcome = runProgram({LODESTONE_CLI, "visibility", (folder / "fence.city.json").string(),
                                      "--targets", (folder / "targets.city.json").string(), "--street", "qem",
                                      "--viewpoint", "500005,4999999,1.5", "--towards", "500005,5000010,1.5",
                                      "--distance", "100", "-o", answer});
  ASSERT_EQ(outcome.status, 3) << outcome.err;  // warned: neither fence nor walls have a footprint
  const Json models = Json::parse(readText(answer))["models"];
  ASSERT_EQ(models.size(), 2U);
  const auto pixels = [&](std::size_t model) { return models[model]["visible"][0]["pixels"].get<double>(); };
  EXPECT_LT(pixels(1), 1.1 * pixels(0));
  EXPECT_GE(pixels(1), pixels(0));
}

TEST(Visibility, AViewpointThatIsNowhereNearIsSaid) {
  const TemporaryFolder folder;
  const std::string town = (folder / "town.city.json").string();
  ASSERT_EQ(runProgram({LODESTONE_CLI, "synth", "-o", town, "--buildings", "20"}).status, 0);
  const auto look = [&](const std::string& eye, const std::string& towards) {
    return runProgram({LODESTONE_CLI, "visibility", town, "--viewpoint", eye, "--towards", towards, "-o",
                       (folder / "answer.json").string()});
  };
  EXPECT_THAT(look("-400000,3,2", "0,0,0").err,
              testing::HasSubstr("m from --viewpoint, and sight goes 1000 m"));
  const auto corner = Json::parse(readText(town))["transform"]["translate"].get<std::vector<double>>();
  const auto beside = [&](double x) {
    return fmt::format("{},{},{}", corner[0] + x, corner[1], corner[2] + 50);
  };
  EXPECT_THAT(look(beside(0), beside(100)).err, testing::Not(testing::HasSubstr("from --viewpoint")));
}

}  // namespace
}  // namespace lodestone::test
