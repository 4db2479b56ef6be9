// The sample town of the resources is made by the program itself, and must be remade byte for byte. After a
// wanted change run this test once with LODESTONE_REMAKE_SAMPLE=1 in the environment.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "algorithms/chains/chain_building.h"
#include "algorithms/synthesis/synthesis.h"
#include "model/io/atomic_file.h"
#include "model/io/cityjson/cityjson_writer.h"
#include "model/io/read_city.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;

const fs::path kSample = fs::path(LODESTONE_SOURCE_DIR) / "resources/sample";

CityModel town() {
  return synthesiseCity({CityPreset::Town, 400, 1});
}

std::string textOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return (std::ostringstream() << file.rdbuf()).str();
}

std::string townText() {
  const auto city = std::make_shared<const CityModel>(town());
  auto chain = makeChain(city, nullptr, {});
  chain->recipe.clear();  // a made-up city has no source that a recipe could name
  const fs::path path = fs::path(testing::TempDir()) / fmt::format("lodestone-town-{}.city.json", ::getpid());
  const auto report = writeCityJson(*chain, path, {}, {});
  EXPECT_TRUE(report);
  const std::string text = textOf(path);
  fs::remove(path);
  return text;
}

std::string streetsText() {
  const CityModel city = town();
  const LineLayer& streets = city.lines.at(0);
  std::string text = fmt::format(
      "{{\"type\":\"FeatureCollection\",\"name\":\"{}\",\"crs\":{{\"type\":\"name\",\"properties\":{{"
      "\"name\":"
      "\"urn:ogc:def:crs:EPSG::{}\"}}}},\"features\":[",
      streets.name, city.crs.epsg);
  for (std::size_t i = 0; i < streets.lines.size(); ++i) {
    text += fmt::format(
        "{}\n{{\"type\":\"Feature\",\"properties\":{{\"highway\":\"{}\"}},\"geometry\":{{\"type\":"
        "\"LineString\","
        "\"coordinates\":[",
        i == 0 ? "" : ",", streets.kinds[i]);
    for (std::size_t k = 0; k < streets.lines[i].size(); ++k) {
      const Vec2 p = streets.lines[i][k] + city.origin.head<2>();
      text += fmt::format("{}[{:.3f},{:.3f}]", k == 0 ? "" : ",", p.x(), p.y());
    }
    text += "]}}";
  }
  return text + "\n]}\n";
}

void expectRemade(const std::string& name, const std::string& text) {
  if (std::getenv("LODESTONE_REMAKE_SAMPLE")) writeFile(kSample / name, text);
  EXPECT_TRUE(textOf(kSample / name) == text) << name << " differs from what the program makes";
  EXPECT_LT(text.size(), std::size_t{1} << 20U);
}

TEST(SampleTown, IsRemadeByteForByte) {
  expectRemade("town.city.json", townText());
  expectRemade("town_streets.geojson", streetsText());
}

TEST(SampleTown, IsReadAsItWasMade) {
  const CityModel made = town();
  const auto read = readCity({kSample / "town.city.json"});
  ASSERT_TRUE(read);
  EXPECT_TRUE(read.diagnostics.empty());
  ASSERT_EQ(read->buildings.size(), made.buildings.size());
  EXPECT_EQ(read->crs.epsg, made.crs.epsg);
  for (std::size_t i = 0; i < made.buildings.size(); ++i) {
    EXPECT_EQ(read->buildings[i].object.id, made.buildings[i].object.id);
    EXPECT_EQ(read->buildings[i].object.attributes, made.buildings[i].object.attributes);
  }
  const auto streets = readLines(kSample / "town_streets.geojson", *read);
  ASSERT_TRUE(streets);
  EXPECT_EQ(streets->lines.size(), made.lines.at(0).lines.size());
  EXPECT_EQ(streets->kinds, made.lines.at(0).kinds);
}

}  // namespace
}  // namespace lodestone
