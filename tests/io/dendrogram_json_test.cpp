#include "model/io/dendrogram_json.h"

#include <limits>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace lodestone {
namespace {

using test::TemporaryFolder;

Dendrogram threeLeaves() {
  Dendrogram d;
  d.leafCount = 3;
  d.options.neighbours = 7;
  d.options.linkage = Linkage::Complete;
  d.merges = {{0, 2, 0.1, 0.1, 0.1, 2}, {1, 3, std::numeric_limits<double>::infinity(), 1e300, 3.5e-17, 3}};
  d.depth = depthOf(d);
  return d;
}

TEST(DendrogramJson, ComesBackToTheLastBit) {
  const TemporaryFolder folder;
  const Dendrogram d = threeLeaves();
  writeDendrogram(d, {"a", "b \"quoted\"", "ü"}, folder / "d.json");
  const Result<LoadedDendrogram> loaded = readDendrogram(folder / "d.json");
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->buildings, (std::vector<std::string>{"a", "b \"quoted\"", "ü"}));
  EXPECT_EQ(loaded->dendrogram.merges, d.merges);
  EXPECT_EQ(loaded->dendrogram.options, d.options);
  EXPECT_EQ(loaded->dendrogram.depth, 2U);
}

TEST(DendrogramJson, MergesThatMakeNoTreeAreRefused) {
  const TemporaryFolder folder;
  Dendrogram d = threeLeaves();
  d.merges[1].b = 2;  // a child already used
  writeDendrogram(d, {"a", "b", "c"}, folder / "d.json");
  EXPECT_FALSE(readDendrogram(folder / "d.json").ok());
  test::writeText(folder / "d.json", "{\"type\": \"dendrogram\"}");
  EXPECT_FALSE(readDendrogram(folder / "d.json").ok());
}

TEST(CutJson, HasTheDocumentedShape) {
  const TemporaryFolder folder;
  Cut cut;
  cut.drawn = {{12, DrawRole::Cluster, kNoNode, 41, 2.1},
               {3, DrawRole::Landmark, 12, 0, 0},
               {5, DrawRole::Building, kNoNode, 0, 0}};
  cut.culled = {77};
  cut.camera.eye = Vec3(1, 2, 3);
  writeCut(cut, folder / "c.json");
  const auto json = nlohmann::json::parse(test::readText(folder / "c.json"));
  EXPECT_EQ(json["camera"]["eye"], (nlohmann::json{1, 2, 3}));
  EXPECT_EQ(json["drawn"][0],
            (nlohmann::json{{"node", 12}, {"role", "cluster"}, {"box_pixels", 41.0}, {"alpha_height", 2.1}}));
  EXPECT_EQ(json["drawn"][1], (nlohmann::json{{"node", 3}, {"role", "landmark"}, {"of", 12}}));
  EXPECT_EQ(json["drawn"][2], (nlohmann::json{{"node", 5}, {"role", "building"}}));
  EXPECT_EQ(json["culled"], nlohmann::json{77});
}

}  // namespace
}  // namespace lodestone
