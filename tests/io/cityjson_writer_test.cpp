#include "model/io/cityjson/cityjson_writer.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "model/io/atomic_file.h"
#include "model/io/cityjson/cityjson_reader.h"
#include "model/io/places/georeference.h"
#include "model/io/read_city.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  Folder() {
    path_ = fs::path(testing::TempDir()) /
            ("cityjson-" + std::to_string(::getpid()) + "-" + std::to_string(counter_++));
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

 private:
  static inline int counter_ = 0;
  fs::path path_;
};

std::string textOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return (std::ostringstream() << file.rdbuf()).str();
}

// Level 0 alone, as algorithms/chains/chain_building.h makes it for buildings with geometry.
LodChain originalChain(std::shared_ptr<const CityModel> city) {
  LodChain chain;
  chain.city = city;
  LodLevel level;
  level.name = "original";
  level.method = "original";
  level.isCity = true;
  level.objectCount = city->buildings.size();
  level.object = [city](std::size_t i) {
    LevelObject object;
    object.id = city->buildings[i].object.id;
    object.buildings = {static_cast<std::uint32_t>(i)};
    object.geometries = city->buildings[i].object.geometries;
    return object;
  };
  chain.levels.push_back(level);
  chain.recipe = "{\n\"type\": \"recipe\"\n}";
  return chain;
}

Geometry surface(const std::vector<Vec3>& ring, const std::string& lod = "1") {
  Geometry geometry;
  geometry.lod = lod;
  geometry.addRing(ring);
  geometry.finishSurface({SurfaceType::Roof, -1, -1});
  return geometry;
}

void expectSame(const CityModel& a, const Geometry& x, const CityModel& b, const Geometry& y,
                const std::string& id) {
  EXPECT_EQ(x.lod, y.lod) << id;
  EXPECT_EQ(x.kind, y.kind) << id;
  EXPECT_EQ(x.shellStart, y.shellStart) << id;
  EXPECT_EQ(x.solidStart, y.solidStart) << id;
  ASSERT_EQ(x.ringStart, y.ringStart) << id;
  ASSERT_EQ(x.surfaceStart, y.surfaceStart) << id;
  for (std::size_t i = 0; i < x.ringVertices.size(); ++i) {
    const Vec3 difference = x.vertices[x.ringVertices[i]] - y.vertices[y.ringVertices[i]];
    ASSERT_LE(difference.cwiseAbs().maxCoeff(), 0.000501) << id;
  }
  for (std::size_t s = 0; s < x.surfaceCount(); ++s) {
    const SurfaceInfo& p = x.surfaces[s];
    const SurfaceInfo& q = y.surfaces[s];
    ASSERT_EQ(p.type, q.type) << id;
    ASSERT_EQ(p.material < 0, q.material < 0) << id;
    if (p.material >= 0) {
      const Material& m = a.materials[static_cast<std::size_t>(p.material)];
      const Material& n = b.materials[static_cast<std::size_t>(q.material)];
      EXPECT_EQ(std::tie(m.name, m.diffuse, m.transparency, m.json),
                std::tie(n.name, n.diffuse, n.transparency, n.json));
    }
    ASSERT_EQ(p.texture < 0, q.texture < 0) << id;
    if (p.texture >= 0) {
      EXPECT_EQ(a.textures[static_cast<std::size_t>(p.texture)].path,
                b.textures[static_cast<std::size_t>(q.texture)].path);
    }
  }
  ASSERT_EQ(x.textureCoordinates.size(), y.textureCoordinates.size()) << id;
  for (std::size_t i = 0; i < x.textureCoordinates.size(); ++i) {
    const bool none = std::isnan(x.textureCoordinates[i].x());
    EXPECT_TRUE(none ? std::isnan(y.textureCoordinates[i].x())
                     : x.textureCoordinates[i] == y.textureCoordinates[i])
        << id;
  }
}

void expectSame(const CityModel& a, const CityObject& x, const CityModel& b, const CityObject& y) {
  EXPECT_EQ(x.id, y.id);
  EXPECT_EQ(x.type, y.type) << x.id;
  EXPECT_EQ(x.attributes, y.attributes) << x.id;
  ASSERT_EQ(x.geometries.size(), y.geometries.size()) << x.id;
  for (std::size_t i = 0; i < x.geometries.size(); ++i)
    expectSame(a, x.geometries[i], b, y.geometries[i], x.id);
  ASSERT_EQ(x.children.size(), y.children.size()) << x.id;
  for (std::size_t i = 0; i < x.children.size(); ++i) expectSame(a, x.children[i], b, y.children[i]);
}

void expectSame(const CityModel& a, const CityModel& b) {
  ASSERT_EQ(a.buildings.size(), b.buildings.size());
  ASSERT_EQ(a.others.size(), b.others.size());
  for (std::size_t i = 0; i < a.buildings.size(); ++i)
    expectSame(a, a.buildings[i].object, b, b.buildings[i].object);
  for (std::size_t i = 0; i < a.others.size(); ++i) expectSame(a, a.others[i], b, b.others[i]);
}

class RoundTrip : public testing::TestWithParam<const char*> {};

TEST_P(RoundTrip, WhatIsWrittenReadsBackTheSame) {
  const fs::path path = test::sharedData("B_cityjson/" + std::string(GetParam()));
  if (path.empty()) GTEST_SKIP() << "shared data not present";
  auto read = readCityJsonDocuments(path, "cityjson", {}, {});
  ASSERT_TRUE(read);
  read->crs.epsg = 0;
  const auto city = std::make_shared<const CityModel>(std::move(*read));
  const Folder folder;
  ASSERT_TRUE(writeCityJson(originalChain(city), folder / "a.city.json", {}, {}));
  ASSERT_TRUE(writeCityJsonSeq(originalChain(city), folder / "a.city.jsonl", {}, {}));
  for (const char* name : {"a.city.json", "a.city.jsonl"}) {
    const auto again = readCityJsonDocuments(folder / name, "cityjson", {}, {});
    ASSERT_TRUE(again) << name;
    EXPECT_FALSE(hasErrors(again.diagnostics));
    expectSame(*city, *again);
  }
}
INSTANTIATE_TEST_SUITE_P(
    Files, RoundTrip,
    testing::Values(
        "denhaag_zip_dtcc/DenHaag_01.city.json.zip", "cjio/delft.json", "cjio/zurich/zurich_subset_lod2.json",
        "cjdb/vienna.jsonl", "cjio/multi_lod.json", "bertt/tests/fixtures/euromast.json",
        "bertt/tests/fixtures/cityjsonseq/montréal_b4.city.jsonl", "duckdb_cityjson/delft_subset.city.jsonl",
        "duckdb_cityjson/hollow_solid.city.json", "duckdb_cityjson/railway_appearance.city.jsonl",
        "cjseq/1b_w_texture.city.json", "cjval/texture4.city.json", "cjval/many2.json", "cjval/address.json",
        "cjio/DH_01_subs.city.json", "fcb/src/rust/fcb_core/tests/data/small.city.jsonl",
        "corpus_conformance_invalid/conformance/v2_0/cityobject_complete/cityobject_complete.city.json"));

// Two buildings in one cluster, the second of them a landmark.
LodChain clusteredChain() {
  auto city = std::make_shared<CityModel>();
  for (const char* id : {"a", "b"}) {
    Building building;
    building.object.id = id;
    building.object.type = ObjectType::Building;
    const double x = id[0] == 'a' ? 0 : 20;
    building.object.geometries.push_back(surface({{x, 0, 5}, {x + 10, 0, 5}, {x + 10, 10, 5}, {x, 10, 5}}));
    city->buildings.push_back(building);
  }
  LodChain chain = originalChain(city);
  LodLevel level;
  level.name = "legible-5m";
  level.method = "legible";
  level.error = 4;
  level.objectCount = 2;
  level.object = [city](std::size_t i) {
    LevelObject object;
    if (i == 0) {
      object.id = "cluster-2";
      object.role = DrawRole::Cluster;
      object.node = 2;
      object.buildings = {0, 1};
      object.negative = 100;
      object.height = 5;
      object.geometries.push_back(surface({{0, 0, 5}, {30, 0, 5}, {30, 10, 5}, {0, 10, 5}}, "1.2"));
    } else {
      object.id = "b";
      object.role = DrawRole::Landmark;
      object.node = 1;
      object.of = 2;
      object.buildings = {1};
      object.geometries = city->buildings[1].object.geometries;
    }
    return object;
  };
  chain.levels.push_back(level);
  return chain;
}

TEST(CityJsonWriter, ClustersAreGroupsThatNameTheirBuildings) {
  const Folder folder;
  const auto report = writeCityJson(clusteredChain(), folder / "c.city.json", {}, {});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->files, std::vector<fs::path>{folder / "c.city.json"});
  const auto json = nlohmann::json::parse(textOf(folder / "c.city.json"));
  const auto& group = json.at("CityObjects").at("L1-cluster-2");
  EXPECT_EQ(group.at("type"), "CityObjectGroup");
  EXPECT_EQ(group.at("children"), nlohmann::json({"a", "b"}));
  EXPECT_EQ(group.at("attributes").at("lodestone:level"), 1);
  EXPECT_EQ(group.at("attributes").at("lodestone:node"), 2);
  EXPECT_EQ(group.at("attributes").at("lodestone:negative"), 100.0);
  EXPECT_EQ(group.at("geometry").at(0).at("lod"), "1.2");
  EXPECT_EQ(json.at("CityObjects").at("b").at("attributes").at("lodestone:landmarkIn"),
            nlohmann::json({"L1-cluster-2"}));
  EXPECT_FALSE(json.at("CityObjects").at("a").contains("attributes"));
  EXPECT_EQ(json.at("metadata").at("lodestone").at("levels").at(1).at("error"), 4.0);
  EXPECT_EQ(json.at("metadata").at("lodestone").at("recipe").at("type"), "recipe");
}

TEST(CityJsonWriter, ACoarseLevelAloneStillHoldsItsBuildings) {
  const Folder folder;
  ASSERT_TRUE(writeCityJson(clusteredChain(), folder / "c.city.json", {{1}}, {}));
  const auto json = nlohmann::json::parse(textOf(folder / "c.city.json"));
  EXPECT_FALSE(json.at("CityObjects").at("a").contains("geometry"));
  EXPECT_EQ(json.at("CityObjects").at("b").at("geometry").size(), 1U);
  EXPECT_EQ(json.at("CityObjects").size(), 3U);
  EXPECT_FALSE(writeCityJson(clusteredChain(), folder / "d.city.json", {{7}}, {}));
}

TEST(CityJsonWriter, TheSameBytesEveryTime) {
  const Folder folder;
  ASSERT_TRUE(writeCityJson(clusteredChain(), folder / "a.city.json", {}, {}));
  ASSERT_TRUE(writeCityJson(clusteredChain(), folder / "b.city.json", {}, {}));
  EXPECT_EQ(textOf(folder / "a.city.json"), textOf(folder / "b.city.json"));
}

TEST(CityJsonWriter, LeavesNothingWhenCancelledOrRefused) {
  const Folder folder;
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(
      (void)writeCityJson(clusteredChain(), folder / "a.city.json", {}, Progress({}, stop.get_token())),
      Cancelled);
  EXPECT_EQ(folder.files(), 0U);
  writeFile(folder / "file", "x");
  const auto refused = writeCityJson(clusteredChain(), folder / "file" / "a.city.json", {}, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.diagnostics.at(0).code, Code::OutputUnwritable);
}

TEST(CityJsonWriter, EverySequenceLineIsADocument) {
  const Folder folder;
  ASSERT_TRUE(writeCityJsonSeq(clusteredChain(), folder / "c.city.jsonl", {}, {}));
  std::ifstream file(folder / "c.city.jsonl");
  std::string line;
  std::vector<std::string> types;
  while (std::getline(file, line)) types.push_back(nlohmann::json::parse(line).at("type"));
  EXPECT_EQ(types,
            (std::vector<std::string>{"CityJSON", "CityJSONFeature", "CityJSONFeature", "CityJSONFeature"}));
}

TEST(CityJsonWriter, EmptyCitiesAreWrittenToo) {
  const Folder folder;
  ASSERT_TRUE(writeCityJson(originalChain(std::make_shared<CityModel>()), folder / "e.city.json", {}, {}));
  EXPECT_TRUE(nlohmann::json::parse(textOf(folder / "e.city.json")).at("vertices").empty());
}

// Images in other folders are copied beside the file, since a path that climbs out of its folder would be
// refused.
TEST(CityJsonWriter, TexturesTravelWithTheFile) {
  const Folder folder;
  fs::create_directories(folder / "in");
  fs::create_directories(folder / "out");
  writeFile(folder / "in" / "wall.png", "not really a picture");
  auto city = std::make_shared<CityModel>();
  city->textures.push_back({(folder / "in" / "wall.png").string(), false, "wrap", "specific"});
  Building building;
  building.object.id = "a";
  building.object.type = ObjectType::Building;
  Geometry geometry = surface({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}});
  geometry.surfaces[0].texture = 0;
  geometry.textureCoordinates = {{0, 0}, {1, 0}, {1, 1}};
  building.object.geometries.push_back(geometry);
  city->buildings.push_back(building);
  const auto report = writeCityJson(originalChain(city), folder / "out" / "a.city.json", {}, {});
  ASSERT_TRUE(report);
  ASSERT_EQ(report->files.size(), 2U);
  const auto again = readCityJsonDocuments(folder / "out" / "a.city.json", "cityjson", {}, {});
  ASSERT_TRUE(again);
  EXPECT_TRUE(again.diagnostics.empty());
  EXPECT_FALSE(again->textures.at(0).missing);
  EXPECT_EQ(textOf(again->textures.at(0).path), "not really a picture");
  EXPECT_EQ(again->buildings.at(0).object.geometries.at(0).textureCoordinates, geometry.textureCoordinates);
}

// An image that cannot be put in its place leaves nothing: neither the file nor the images before it.
TEST(CityJsonWriter, LeavesNothingWhenAnImageCannotBeCopied) {
  const Folder folder;
  fs::create_directories(folder / "in");
  auto city = std::make_shared<CityModel>();
  Building& building = city->buildings.emplace_back();
  building.object.id = "a";
  building.object.type = ObjectType::Building;
  for (std::int32_t i = 0; i < 2; ++i) {
    const fs::path image = folder / "in" / (std::to_string(i) + ".png");
    if (i == 0) writeFile(image, "pixels");
    city->textures.push_back({image.string(), false, "wrap", "specific"});
    Geometry geometry = surface({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}});
    geometry.surfaces[0].texture = i;
    geometry.textureCoordinates = {{0, 0}, {1, 0}, {1, 1}};
    building.object.geometries.push_back(geometry);
  }
  for (const auto write : {writeCityJson, writeCityJsonSeq}) {
    EXPECT_FALSE(write(originalChain(city), folder / "out" / "a.city.json", {}, {}));
    EXPECT_FALSE(fs::exists(folder / "out"));
  }
}

// Objects that a schema allows only below others, or with other geometries, become the nearest that it
// allows.
TEST(CityJsonWriter, FitsObjectsIntoTheSchema) {
  auto city = std::make_shared<CityModel>();
  CityObject room;
  room.id = "room";
  room.type = ObjectType::BuildingRoom;
  CityObject relief;
  relief.id = "relief";
  relief.type = ObjectType::Relief;
  relief.geometries.push_back(surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "4"));
  CityObject misspelt;
  misspelt.id = "misspelt";
  misspelt.attributes.set("cityjson:type", std::string("Bulding"));
  CityObject noise;
  noise.id = "noise";
  noise.attributes.set("cityjson:type", std::string("+Noise"));
  city->others = {room, relief, misspelt, noise};
  const Folder folder;
  const auto report = writeCityJson(originalChain(city), folder / "a.city.json", {}, {});
  ASSERT_TRUE(report);
  ASSERT_EQ(report.diagnostics.size(), 1U);
  EXPECT_EQ(report.diagnostics[0].code, Code::OutputLossy);
  const auto json = nlohmann::json::parse(textOf(folder / "a.city.json"));
  EXPECT_EQ(json.at("CityObjects").at("room").at("type"), "GenericCityObject");
  EXPECT_EQ(json.at("CityObjects").at("misspelt").at("type"), "GenericCityObject");
  EXPECT_EQ(json.at("CityObjects").at("misspelt").at("attributes").at("cityjson:type"), "Bulding");
  EXPECT_EQ(json.at("CityObjects").at("noise"), nlohmann::json({{"type", "+Noise"}}));
  const auto& geometry = json.at("CityObjects").at("relief").at("geometry").at(0);
  EXPECT_EQ(geometry.at("type"), "CompositeSurface");
  EXPECT_EQ(geometry.at("lod"), "3.3");
}

// A member of the root or a type that starts with "+" belongs to an extension, which has to be declared.
TEST(CityJsonWriter, DeclaresExtensionsAndUsesNoneOfItsOwn) {
  auto city = std::make_shared<CityModel>();
  city->sources.push_back(
      {"a.city.json", "cityjson", "2.0", "", R"({"Noise":{"url":"noise.ext.json","version":"1.0"}})"});
  city->sources.push_back(
      {"b.city.json", "cityjson", "2.0", "",
       R"({"Noise":{"url":"other","version":"2.0"},"Solar":{"url":"solar.ext.json","version":"1.0"}})"});
  Building building;
  building.object.id = "b";
  building.object.type = ObjectType::Building;
  building.object.geometries.push_back(surface({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}));
  building.object.geometries[0].surfaces[0].type = SurfaceType::Generic;
  city->buildings.push_back(building);
  const Folder folder;
  ASSERT_TRUE(writeCityJson(originalChain(city), folder / "a.city.json", {}, {}));
  const auto json = nlohmann::json::parse(textOf(folder / "a.city.json"));
  EXPECT_EQ(json.at("extensions").at("Noise").at("url"), "noise.ext.json");
  EXPECT_EQ(json.at("extensions").at("Solar").at("version"), "1.0");
  for (const auto& [key, value] : json.items()) EXPECT_NE(key.front(), '+') << key;
  EXPECT_EQ(json.dump().find("\"+"), std::string::npos);
  const auto again = readCityJsonDocuments(folder / "a.city.json", "cityjson", {}, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(nlohmann::json::parse(again->sources.at(0).extensions), json.at("extensions"));
}

// CityGML's readers keep one address as an object; the schema wants a list of objects, and in them a
// `location` by vertices only.
TEST(CityJsonWriter, AddressesAreLists) {
  auto city = std::make_shared<CityModel>();
  const auto addBuilding = [&](const std::string& id, const std::string& address) {
    Building& building = city->buildings.emplace_back();
    building.object.id = id;
    building.object.type = ObjectType::Building;
    building.object.attributes.set("address", JsonText{address});
  };
  addBuilding("one", R"({"CountryName":"Germany","location":"here"})");
  addBuilding("two", R"([{"CountryName":"France"},{"CountryName":"Italy"}])");
  addBuilding("words", R"(["Main Street"])");
  const Folder folder;
  ASSERT_TRUE(writeCityJson(originalChain(city), folder / "a.city.json", {}, {}));
  const auto objects = nlohmann::json::parse(textOf(folder / "a.city.json")).at("CityObjects");
  const auto expected = [](const char* text) { return nlohmann::json::parse(text); };
  EXPECT_EQ(objects.at("one").at("address"), expected(R"([{"CountryName":"Germany"}])"));
  EXPECT_EQ(objects.at("two").at("address"),
            expected(R"([{"CountryName":"France"},{"CountryName":"Italy"}])"));
  EXPECT_FALSE(objects.at("words").contains("address"));
  EXPECT_EQ(objects.at("words").at("attributes").at("address"), expected(R"(["Main Street"])"));
  EXPECT_THAT(kCityJsonLosses, testing::HasSubstr("points of addresses"));
}

/// Beside ten kilometres a speck is nothing; by itself it is written in steps of its own.
TEST(CityJsonWriter, WhatMillimetresCannotTellIsSaid) {
  auto city = std::make_shared<CityModel>();
  CityObject speck;
  speck.id = "speck";
  speck.type = ObjectType::GenericObject;
  speck.geometries.push_back(surface({{0, 0, 0}, {1e-4, 0, 0}, {0, 1e-4, 0}}));
  city->others = {speck};
  const Folder folder;
  EXPECT_TRUE(writeCityJson(originalChain(city), folder / "a.city.json", {}, {}).diagnostics.empty());
  CityObject field = speck;
  field.id = "field";
  field.geometries = {surface({{0, 0, 0}, {1e4, 0, 0}, {0, 1e4, 0}})};
  city->others.push_back(field);
  const auto report = writeCityJson(originalChain(city), folder / "b.city.json", {}, {});
  ASSERT_TRUE(report);
  ASSERT_EQ(report.diagnostics.size(), 1U);
  EXPECT_EQ(report.diagnostics[0].code, Code::OutputLossy);
}

// Local metres go back to degrees, in the order of the authority, and come in again at the same places.
TEST(CityJsonWriter, GeographicModelsKeepTheirPlace) {
  for (const char* spelling :
       {"https://www.opengis.net/def/crs/EPSG/0/4326", "https://www.opengis.net/def/crs/EPSG/0/25832"}) {
    auto city = std::make_shared<CityModel>();
    city->crs = resolveCrs(spelling);
    const bool degrees = city->crs.kind == CrsKind::Geographic;
    city->origin = degrees ? Vec3(8.5, 49.25, 0) : Vec3(500000, 5400000, 0);
    Building building;
    building.object.id = "a";
    building.object.type = ObjectType::Building;
    building.object.geometries.push_back(surface({{-300, -200, 12}, {700, -200, 12}, {700, 400, 12}}));
    city->buildings.push_back(building);
    const Folder folder;
    ASSERT_TRUE(writeCityJson(originalChain(city), folder / "g.city.json", {}, {}));
    const auto again = readCity({folder / "g.city.json"});
    ASSERT_TRUE(again);
    EXPECT_EQ(again->crs.kind, city->crs.kind);
    const Geometry& before = building.object.geometries[0];
    const Geometry& after = again->buildings.at(0).object.geometries.at(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 was = toWorld(*city, before.vertices[before.ringVertices[i]]);
      const Vec3 is = toWorld(*again, after.vertices[after.ringVertices[i]]);
      EXPECT_LT((was - is).cwiseAbs().maxCoeff(), degrees ? 6e-4 : 5.1e-4) << spelling;
      EXPECT_LT((was - is).head<2>().cwiseAbs().maxCoeff(), degrees ? 1e-9 : 5.1e-4) << spelling;
    }
  }
}

}  // namespace
}  // namespace lodestone
