// The main job on real data: import, cluster, merge, cut, export. Skips where the data is absent.
#include <numeric>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"
#include "tests/support/shared_data.h"

namespace lodestone::test {
namespace {

using Json = nlohmann::json;

struct Case {
  const char* name;
  std::vector<std::string>
      files;              ///< below the shared "data" folder; a trailing "/*" takes all files of a folder
  std::size_t buildings;  ///< as the data's README counts them
  std::vector<std::string> options = {};
  std::vector<std::string> barriers = {};
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

std::vector<std::string> filesOf(const std::vector<std::string>& patterns) {
  std::vector<std::string> files;
  for (const std::string& pattern : patterns) {
    if (!pattern.ends_with("/*")) {
      const auto path = sharedData(pattern);
      if (path.empty()) return {};
      files.push_back(path.string());
      continue;
    }
    const auto folder = sharedData(pattern.substr(0, pattern.size() - 2));
    if (folder.empty()) return {};
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Buildings that the report says were left out because their footprint cannot be repaired.
std::size_t leftOut(const Json& report) {
  std::size_t count = 0;
  for (const Json& d : report["diagnostics"])
    count += d["code"] == 217 && !d["object"].get<std::string>().empty() ? 1 : 0;
  return count;
}

void doTheMainJob(const Case& c) {
  const std::vector<std::string> files = filesOf(c.files);
  if (files.empty()) GTEST_SKIP() << "shared data not present";
  const TemporaryFolder folder;
  std::vector<std::string> command{LODESTONE_CLI, "chain"};
  command.insert(command.end(), files.begin(), files.end());
  command.insert(command.end(), c.options.begin(), c.options.end());
  for (const std::string& path : filesOf(c.barriers)) command.insert(command.end(), {"--barriers", path});
  command.insert(command.end(),
                 {"-o", (folder / "chain").string(), "--formats", "cityjson,glb,obj,geojson,gpkg", "--report",
                  (folder / "report.json").string()});
  const Outcome outcome = runProgram(command);
  ASSERT_THAT(outcome.status, testing::AnyOf(0, 3)) << outcome.err;
  const Json report = Json::parse(readText(folder / "report.json"));
  EXPECT_EQ(report["input"]["buildings"].get<std::size_t>() + leftOut(report), c.buildings) << outcome.err;
  const Json& levels = report["figures"]["levels"];
  ASSERT_GE(levels.size(), c.buildings > 1 ? 2U : 1U);
  for (std::size_t i = 2; i < levels.size(); ++i) {
    EXPECT_LE(levels[i]["polygons"], levels[i - 1]["polygons"]) << "coarser levels have fewer polygons";
    EXPECT_GE(levels[i]["error"], levels[i - 1]["error"]);
  }
  for (const Json& file : report["output"]["files"]) {
    EXPECT_GT(std::filesystem::file_size(file.get<std::string>()), 0U) << file;
  }
}

class RealData : public testing::TestWithParam<Case> {};
TEST_P(RealData, ChainDoesTheMainJob) {
  doTheMainJob(GetParam());
}
INSTANTIATE_TEST_SUITE_P(
    Small, RealData,
    testing::Values(Case{"Berlin", {"A_citygml/berlin_lod2_argis/Berlin1b/*"}, 137},
                    Case{"Nrw", {"A_citygml/nrw_lod2/LoD2_32_280_5657_1_NW.gml"}, 83},
                    Case{"Plateau", {"A_citygml/plateau_tiles_yuuhayashi/53375768_bldg_6697_op.gml"}, 329},
                    Case{"Potsdam",
                         {"A_citygml/potsdam_berlin_3dcitydb/Potsdam/CityGML/Potsdam_LoD1/Potsdam_LoD1.gml"},
                         97},
                    Case{
                        "FzkHaus", {"A_citygml/fzkhaus_all_lods/FZK-Haus-LoD-all-KIT-IAI-KHH-B36-V1.zip"}, 1},
                    Case{"DenHaag", {"B_cityjson/denhaag_zip_dtcc/DenHaag_01.city.json.zip"}, 844},
                    Case{"Geoclimate",
                         {"C_footprints/geoclimate_heights_roads/BUILDING.geojson"},
                         2506,
                         {"--height", "HEIGHT_ROOF"},
                         {"C_footprints/geoclimate_heights_roads/ROAD.geojson"}}),
    [](const auto& test) { return test.param.name; });

class LongRealData : public testing::TestWithParam<Case> {};
TEST_P(LongRealData, ChainDoesTheMainJob) {
  doTheMainJob(GetParam());
}
INSTANTIATE_TEST_SUITE_P(
    Large, LongRealData,
    testing::Values(Case{"Hancock", {"C_footprints/hancock_ms_41k_shp/tiled_footprints.zip"}, 41023},
                    Case{"Allegheny", {"C_footprints/allegheny_547k_osm/*"}, 122649},
                    Case{"Monaco",
                         {"C_footprints/osm_with_streets/monaco-latest.osm.pbf"},
                         1207,
                         {},
                         {"C_footprints/osm_with_streets/monaco-latest.osm.pbf"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace lodestone::test
