#include "model/io/project_file.h"

#include <gmock/gmock.h>

#include "tests/support/run_program.h"

namespace lodestone {
namespace {

using test::TemporaryFolder;

ProjectState sample(const TemporaryFolder& folder) {
  ProjectState state;
  state.sources = {(folder / "data/tile one.gml").string(), (folder / "b.city.json").string()};
  state.barriers = {(folder / "streets.geojson").string()};
  state.importOptions.crs = "EPSG:25833";
  state.importOptions.floorHeight = 2.75;
  state.clusterOptions.linkage = Linkage::Single;
  state.clusterOptions.neighbours = 12;
  state.mergeOptions.edgeRatio = 0.5;
  state.chainOptions = {.tolerances = "3,7.5", .cut = {.epsilon = 321}, .fov = 30};
  state.simplifyOptions.rate = 0.625;
  state.comparedOptions.a = 3.5;
  state.sight.standAt(Vec3(1.5, -2e5, 31.25));
  state.sight.heading = 271.5;
  state.cutChoice = {CutMode::Weight, 1.25e9};
  state.camera.eye = Vec3(0.1, 1e7, -3.25);
  state.camera.width = 640;
  return state;
}

TEST(ProjectFile, ComesBackAsItWas) {
  const TemporaryFolder folder;
  const ProjectState state = sample(folder);
  ASSERT_TRUE(saveProject(state, folder / "town.lodestone", "layout text").ok());
  const Result<LoadedProject> loaded = loadProject(folder / "town.lodestone");
  ASSERT_TRUE(loaded.ok());
  EXPECT_TRUE(loaded.diagnostics.empty());
  EXPECT_EQ(loaded->layout, "layout text");
  EXPECT_EQ(loaded->state.sources, state.sources);
  EXPECT_EQ(loaded->state.barriers, state.barriers);
  EXPECT_EQ(loaded->state.importOptions, state.importOptions);
  EXPECT_EQ(loaded->state.clusterOptions, state.clusterOptions);
  EXPECT_EQ(loaded->state.mergeOptions, state.mergeOptions);
  EXPECT_EQ(loaded->state.chainOptions, state.chainOptions);
  EXPECT_EQ(loaded->state.simplifyOptions, state.simplifyOptions);
  EXPECT_EQ(loaded->state.comparedOptions, state.comparedOptions);
  EXPECT_EQ(loaded->state.sight, state.sight);
  EXPECT_EQ(loaded->state.cutChoice, state.cutChoice);
  EXPECT_EQ(loaded->state.camera, state.camera);
}

TEST(ProjectFile, FilesFromBeforeChainsWereKeptAreRead) {
  const TemporaryFolder folder;
  test::writeText(folder / "old.lodestone", R"({"type": "lodestone-project", "version": 1, "sources": [],
    "options": {"cut": {"epsilon": 0, "alpha": 5}}})");
  const Result<LoadedProject> loaded = loadProject(folder / "old.lodestone");
  ASSERT_TRUE(loaded.ok());
  EXPECT_TRUE(loaded.diagnostics.empty());
  EXPECT_EQ(loaded->state.chainOptions, (ChainOptions{.cut = {.epsilon = 0, .alpha = 5}}));
}

TEST(ProjectFile, EveryChoiceOfTheDrawnCutComesBack) {
  const TemporaryFolder folder;
  for (const CutMode mode : {CutMode::Camera, CutMode::Weight, CutMode::Tolerance, CutMode::Original}) {
    ProjectState state = sample(folder);
    state.cutChoice = {mode, 0.5};
    ASSERT_TRUE(saveProject(state, folder / "town.lodestone").ok());
    const Result<LoadedProject> loaded = loadProject(folder / "town.lodestone");
    ASSERT_TRUE(loaded.ok());
    EXPECT_EQ(loaded->state.cutChoice, state.cutChoice);
  }
}

TEST(ProjectFile, AnUnknownChoiceOfTheDrawnCutIsSaidAndTheCameraChooses) {
  const TemporaryFolder folder;
  for (const std::string drawn : {R"({"from": "moon"})", R"({"from": "weight", "value": -1})"}) {
    test::writeText(folder / "odd.lodestone",
                    R"({"type": "lodestone-project", "version": 1, "sources": [], "drawn": )" + drawn + "}");
    const Result<LoadedProject> loaded = loadProject(folder / "odd.lodestone");
    ASSERT_TRUE(loaded.ok());
    ASSERT_EQ(loaded.diagnostics.size(), 1U);
    EXPECT_EQ(loaded.diagnostics.front().code, Code::OptionBadValue);
    EXPECT_EQ(loaded->state.cutChoice, CutChoice{});
  }
}

TEST(ProjectFile, MovesWithItsFolder) {
  const TemporaryFolder folder;
  const ProjectState state = sample(folder);
  ASSERT_TRUE(saveProject(state, folder / "project/town.lodestone").ok());
  std::filesystem::create_directories(folder / "moved");
  std::filesystem::rename(folder / "project", folder / "moved/project");
  const Result<LoadedProject> loaded = loadProject(folder / "moved/project/town.lodestone");
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->state.sources[1], (folder / "moved/b.city.json").string());
}

TEST(ProjectFile, BrokenFilesAreSaid) {
  const TemporaryFolder folder;
  EXPECT_EQ(loadProject(folder / "none.lodestone").diagnostics.front().code, Code::FileNotFound);
  for (const std::string text :
       {"", "{", "[1, 2]", "7", R"({"type": "other"})", R"({"type": "lodestone-project", "version": 99})",
        R"({"type": "lodestone-project", "version": 1})",
        R"({"type": "lodestone-project", "version": 1, "sources": 3})",
        R"({"type": "lodestone-project", "version": 1, "sources": [], "drawn": {"from": 3}})",
        R"({"type": "lodestone-project", "version": 1, "sources": [], "camera": {"eye": [1]}})"}) {
    test::writeText(folder / "bad.lodestone", text);
    const Result<LoadedProject> loaded = loadProject(folder / "bad.lodestone");
    EXPECT_FALSE(loaded.ok()) << text;
    ASSERT_FALSE(loaded.diagnostics.empty()) << text;
    EXPECT_EQ(loaded.diagnostics.front().code, Code::ProjectBad) << text;
  }
}

TEST(ProjectFile, OptionsOutOfRangeAreSaidAndLeftAtTheirDefault) {
  const TemporaryFolder folder;
  test::writeText(folder / "odd.lodestone", R"({"type": "lodestone-project", "version": 1, "sources": [],
    "options": {"cluster": {"neighbours": -4, "colour": "red"}}})");
  const Result<LoadedProject> loaded = loadProject(folder / "odd.lodestone");
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded.diagnostics.size(), 2U);
  EXPECT_EQ(loaded->state.clusterOptions, ClusterOptions{});
}

TEST(ProjectFile, AFolderThatCannotBeWrittenIsSaid) {
  const TemporaryFolder folder;
  test::writeText(folder / "file", "in the way");
  const Result<bool> saved = saveProject({}, folder / "file/town.lodestone");
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.diagnostics.front().code, Code::OutputUnwritable);
}

}  // namespace
}  // namespace lodestone
