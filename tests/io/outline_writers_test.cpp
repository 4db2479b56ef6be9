#include <fstream>

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <ogrsf_frmts.h>

#include "model/io/atomic_file.h"
#include "model/io/gdal_support.h"
#include "model/io/outlines/geojson.h"
#include "model/io/outlines/gpkg.h"
#include "model/io/outlines/hulls_layer.h"
#include "model/io/places/georeference.h"
#include "model/io/read_city.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;

Ring square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

fs::path folder(const std::string& name) {
  const fs::path path = fs::path(::testing::TempDir()) / "outline_writers" / name;
  fs::remove_all(path);
  fs::create_directories(path);
  return path;
}

std::string bytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::shared_ptr<CityModel> cityOf(int buildings, const std::string& crs, const Vec3& origin) {
  auto city = std::make_shared<CityModel>();
  city->crs = resolveCrs(crs);
  city->origin = origin;
  for (int i = 0; i < buildings; ++i) {
    Building building;
    building.object.id = "house \"" + std::to_string(i) + "\"";
    building.footprint = {{square(20.0 * i, 0, 10), i == 0
                                                        ? std::vector<Ring>{{{2, 2}, {2, 4}, {4, 4}, {4, 2}}}
                                                        : std::vector<Ring>{}}};
    building.height = 3 + i;
    building.base = 100;
    city->buildings.push_back(building);
  }
  return city;
}

LevelObject original(const CityModel& city, std::size_t i) {
  LevelObject object;
  object.id = city.buildings[i].object.id;
  object.buildings = {static_cast<std::uint32_t>(i)};
  object.base = city.buildings[i].base;
  object.height = city.buildings[i].height;
  object.footprint = city.buildings[i].footprint;
  return object;
}

LodChain chainOf(std::shared_ptr<CityModel> city) {
  LodChain chain;
  chain.city = city;
  chain.recipe = R"({"type":"recipe","version":1})";
  LodLevel all;
  all.name = "original";
  all.objectCount = city->buildings.size();
  all.object = [city](std::size_t i) { return original(*city, i); };
  LodLevel coarse;
  coarse.name = "legible-10m";
  coarse.objectCount = 1;
  coarse.object = [city](std::size_t) {
    LevelObject object;
    object.id = "cluster-7";
    object.role = DrawRole::Cluster;
    object.node = 7;
    for (std::uint32_t i = 0; i < city->buildings.size(); ++i) object.buildings.push_back(i);
    object.negative = 12.5;
    object.footprint = {{square(0, 0, 100), {}}, {square(200, 0, 5), {}}};
    return object;
  };
  chain.levels = {all, coarse};
  return chain;
}

TEST(GeoJsonWriter, KeepsLevelsIdsSourcesAndSystem) {
  const auto city = cityOf(3, "EPSG:25832", {458880, 5438360, 0});
  const fs::path path = folder("geojson") / "chain.geojson";
  const auto result = geoJsonFormat().write(chainOf(city), path, {}, {});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->files, std::vector<fs::path>{path});
  const auto json = nlohmann::json::parse(bytes(path));
  EXPECT_EQ(json["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::25832");
  EXPECT_EQ(json["recipe"]["type"], "recipe");
  ASSERT_EQ(json["features"].size(), 4U);
  const auto& first = json["features"][0];
  EXPECT_EQ(first["properties"]["id"], "house \"0\"");
  EXPECT_EQ(first["properties"]["level"], "original");
  EXPECT_EQ(first["properties"]["role"], "building");
  EXPECT_TRUE(first["properties"]["node"].is_null());
  EXPECT_EQ(first["geometry"]["coordinates"].size(), 2U);  // with its hole
  EXPECT_EQ(first["geometry"]["coordinates"][0][0], nlohmann::json({458880.0, 5438360.0}));
  EXPECT_EQ(first["geometry"]["coordinates"][0].front(), first["geometry"]["coordinates"][0].back());
  const auto& cluster = json["features"][3];
  EXPECT_EQ(cluster["properties"]["building_ids"].size(), 3U);
  EXPECT_EQ(cluster["properties"]["node"], 7);
  EXPECT_EQ(cluster["geometry"]["type"], "MultiPolygon");
}

TEST(GeoJsonWriter, WhatItWritesIsReadAtTheSamePlace) {
  for (const auto& [crs, origin] :
       std::vector<std::pair<std::string, Vec3>>{{"EPSG:25832", {458880, 5438360, 0}},
                                                 {"EPSG:4326", {8.43, 49.1, 0}},
                                                 {"EPSG:2263", {300000, 60000, 0}}}) {
    const auto city = cityOf(3, crs, origin);
    const fs::path path = folder("again") / "town.geojson";
    WriteOptions options;
    options.levels = {0};
    ASSERT_TRUE(geoJsonFormat().write(chainOf(city), path, options, {}).ok());
    const Result<CityModel> again = readCity({path});
    ASSERT_TRUE(again.ok());
    ASSERT_EQ(again->buildings.size(), 3U);
    EXPECT_EQ(again->crs.epsg, city->crs.epsg);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(again->buildings[i].object.id, city->buildings[i].object.id);
      EXPECT_EQ(again->buildings[i].height, city->buildings[i].height);
      const Ring& before = city->buildings[i].footprint[0].outer;
      const Ring& after = again->buildings[i].footprint[0].outer;
      ASSERT_EQ(after.size(), before.size());
      for (std::size_t k = 0; k < before.size(); ++k) {
        const Vec3 p(before[k].x(), before[k].y(), 0);
        const Vec3 q(after[k].x(), after[k].y(), 0);
        EXPECT_LT((toWorld(*city, p) - toWorld(*again, q)).norm(), 2e-6) << crs;
      }
    }
  }
}

TEST(GeoJsonWriter, UnknownSystemIsNull) {
  const auto city = cityOf(1, "", Vec3::Zero());
  const fs::path path = folder("unknown") / "town.geojson";
  ASSERT_TRUE(geoJsonFormat().write(chainOf(city), path, {}, {}).ok());
  EXPECT_TRUE(nlohmann::json::parse(bytes(path))["crs"].is_null());
}

TEST(GeoPackageWriter, HasALayerALevelAndTheSourceTable) {
  const auto city = cityOf(3, "urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::5783", {458880, 5438360, 0});
  const fs::path path = folder("gpkg") / "chain.gpkg";
  const auto result = geoPackageFormat().write(chainOf(city), path, {}, {});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->files, std::vector<fs::path>{path});
  const GdalErrors errors;
  const DatasetPtr dataset = openVector(path.string());
  ASSERT_TRUE(dataset);
  OGRLayer* original = dataset->GetLayerByName("original");
  ASSERT_TRUE(original);
  EXPECT_EQ(original->GetFeatureCount(), 3);
  EXPECT_STREQ(original->GetSpatialRef()->GetAuthorityCode(nullptr), "25832");
  OGRLayer* coarse = dataset->GetLayerByName("legible-10m");
  ASSERT_TRUE(coarse);
  const OGRFeatureUniquePtr cluster(coarse->GetNextFeature());
  EXPECT_STREQ(cluster->GetFieldAsString("id"), "cluster-7");
  EXPECT_STREQ(cluster->GetFieldAsString("role"), "cluster");
  EXPECT_EQ(cluster->GetFieldAsInteger("buildings"), 3);
  EXPECT_EQ(cluster->GetFieldAsDouble("negative"), 12.5);
  EXPECT_NEAR(cluster->GetGeometryRef()->toMultiPolygon()->get_Area(), 10025, 1e-6);
  OGRLayer* sources = dataset->GetLayerByName("source_ids");
  ASSERT_TRUE(sources);
  EXPECT_EQ(sources->GetFeatureCount(), 6);
  OGRLayer* recipe = dataset->GetLayerByName("recipe");
  ASSERT_TRUE(recipe);
  EXPECT_EQ(OGRFeatureUniquePtr(recipe->GetNextFeature())->GetFieldAsString("recipe"), chainOf(city).recipe);
  EXPECT_TRUE(errors.failures().empty()) << errors.joined();
}

/// Attributes of all kinds, and names that are taken: by our own columns, by the format, by case.
std::shared_ptr<CityModel> attributedCity() {
  auto city = cityOf(2, "EPSG:25832", {458880, 5438360, 0});
  Attributes& first = city->buildings[0].object.attributes;
  first.set("storeys", std::int64_t{3});
  first.set("area", std::int64_t{100});
  first.set("Height", std::string("tall"));
  first.set("fid", std::int64_t{17});
  first.set("address", JsonText{R"(["Main \"St\""])"});
  first.set("listed", true);
  Attributes& second = city->buildings[1].object.attributes;
  second.set("area", 12.5);
  second.set("AREA", std::string("x"));
  return city;
}

TEST(GeoPackageWriter, KeepsAttributesOfSingleBuildings) {
  const fs::path path = folder("attributes") / "town.gpkg";
  ASSERT_TRUE(geoPackageFormat().write(chainOf(attributedCity()), path, {}, {}).ok());
  const DatasetPtr dataset = openVector(path.string());
  OGRLayer* layer = dataset->GetLayerByName("original");
  OGRFeatureDefn* fields = layer->GetLayerDefn();
  const auto type = [&](const char* name) {
    const int field = fields->GetFieldIndex(name);
    return field < 0 ? OFTBinary : fields->GetFieldDefn(field)->GetType();
  };
  EXPECT_EQ(type("storeys"), OFTInteger64);
  EXPECT_EQ(type("area"), OFTReal);
  EXPECT_EQ(type("AREA_source"), OFTString);
  const OGRFeatureUniquePtr first(layer->GetNextFeature());
  EXPECT_EQ(first->GetFieldAsInteger("storeys"), 3);
  EXPECT_EQ(first->GetFieldAsDouble("area"), 100);
  EXPECT_EQ(first->GetFieldAsDouble("height"), 3);
  EXPECT_STREQ(first->GetFieldAsString("Height_source"), "tall");
  EXPECT_EQ(first->GetFieldAsInteger("fid_source"), 17);
  EXPECT_STREQ(first->GetFieldAsString("address"), R"(["Main \"St\""])");
  EXPECT_STREQ(first->GetFieldAsString("listed"), "true");
  const OGRFeatureUniquePtr second(layer->GetNextFeature());
  EXPECT_EQ(second->GetFieldAsDouble("area"), 12.5);
  EXPECT_STREQ(second->GetFieldAsString("AREA_source"), "x");
  EXPECT_FALSE(second->IsFieldSetAndNotNull(second->GetFieldIndex("storeys")));
  const OGRFeatureUniquePtr cluster(dataset->GetLayerByName("legible-10m")->GetNextFeature());
  EXPECT_FALSE(cluster->IsFieldSetAndNotNull(cluster->GetFieldIndex("area")));
}

TEST(GeoJsonWriter, NamesTheAttributesThatABuildingHas) {
  const fs::path path = folder("attributes") / "town.geojson";
  ASSERT_TRUE(geoJsonFormat().write(chainOf(attributedCity()), path, {}, {}).ok());
  const auto features = nlohmann::json::parse(bytes(path))["features"];
  EXPECT_EQ(features[0]["properties"]["area"], 100);
  EXPECT_EQ(features[0]["properties"]["storeys"], 3);
  EXPECT_FALSE(features[1]["properties"].contains("storeys"));
  EXPECT_FALSE(features[2]["properties"].contains("area"));
}

TEST(OutlineWriters, LoseNoneOfVeryManyAttributes) {
  const auto city = cityOf(2, "EPSG:25832", {458880, 5438360, 0});
  constexpr std::int64_t kNames = 2500;  // more columns than SQLite takes
  for (std::int64_t i = 0; i < kNames; ++i) {
    city->buildings[0].object.attributes.set("tag " + std::to_string(i), i);
    if (i == kNames - 1) city->buildings[1].object.attributes.set("tag " + std::to_string(i), i);
  }
  const fs::path path = folder("many") / "town.gpkg";
  ASSERT_TRUE(geoPackageFormat().write(chainOf(city), path, {}, {}).ok());
  const DatasetPtr dataset = openVector(path.string());
  const OGRFeatureUniquePtr first(dataset->GetLayerByName("original")->GetNextFeature());
  EXPECT_EQ(first->GetFieldAsInteger("tag 2499"), 2499) << "used twice: among the most used";
  const auto others = nlohmann::json::parse(first->GetFieldAsString("other_attributes"));
  int columns = 0;
  for (std::int64_t i = 0; i < kNames; ++i) {
    const std::string name = "tag " + std::to_string(i);
    const int field = first->GetFieldIndex(name.c_str());
    columns += field >= 0 ? 1 : 0;
    EXPECT_EQ(field >= 0 ? first->GetFieldAsInteger(field) : others.at(name).get<int>(), i);
  }
  EXPECT_GT(columns, 100);
}

TEST(OutlineWriters, TheSameInputGivesTheSameBytes) {
  const auto city = cityOf(50, "EPSG:25832", {458880, 5438360, 0});
  const fs::path place = folder("same");
  for (const Format& format : {geoJsonFormat(), geoPackageFormat()}) {
    const std::string ending(format.extensions.front());
    // The same name twice: GeoJSON holds it.
    const fs::path path = place / ("town" + ending);
    ASSERT_TRUE(format.write(chainOf(city), path, {}, {}).ok());
    const std::string first = bytes(path);
    ASSERT_TRUE(format.write(chainOf(city), path, {}, {}).ok());
    EXPECT_FALSE(first.empty());
    EXPECT_TRUE(first == bytes(path)) << ending;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(place), {}), 2);  // nothing half-done is left
}

TEST(OutlineWriters, SayWhereTheyCannotWrite) {
  const auto city = cityOf(1, "EPSG:25832", Vec3::Zero());
  const fs::path place = folder("unwritable");
  writeFile(place / "file", "not a folder");
  for (const Format& format : {geoJsonFormat(), geoPackageFormat()}) {
    const auto result = format.write(
        chainOf(city), place / "file" / ("town" + std::string(format.extensions.front())), {}, {});
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.diagnostics.front().code, Code::OutputUnwritable);
  }
}

TEST(OutlineWriters, CancelLeavesTheOldFile) {
  const auto city = cityOf(10, "EPSG:25832", Vec3::Zero());
  const fs::path place = folder("cancel");
  std::stop_source stop;
  stop.request_stop();
  for (const Format& format : {geoJsonFormat(), geoPackageFormat()}) {
    const fs::path path = place / ("town" + std::string(format.extensions.front()));
    writeFile(path, "old");
    EXPECT_THROW((void)format.write(chainOf(city), path, {}, Progress({}, stop.get_token())), Cancelled);
    EXPECT_EQ(bytes(path), "old");
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(place), {}), 2);
}

ClusterTree treeOf(const CityModel& city) {
  ClusterTree tree;
  const auto add = [&](NodeId parent, NodeId a, NodeId b, const Ring& hull) {
    ClusterNode node;
    node.parent = parent;
    node.a = a;
    node.b = b;
    node.size = a == kNoNode ? 1 : 2;
    node.hullBegin = tree.hullVertices.size();
    node.edges = static_cast<std::uint32_t>(hull.size());
    node.area = signedArea(hull);
    node.negative = a == kNoNode ? 0 : 100;
    node.height = 3;
    node.base = 100;
    node.maxTop = 104;
    tree.hullVertices.insert(tree.hullVertices.end(), hull.begin(), hull.end());
    tree.nodes.push_back(node);
  };
  add(2, kNoNode, kNoNode, city.buildings[0].footprint[0].outer);
  add(2, kNoNode, kNoNode, city.buildings[1].footprint[0].outer);
  add(kNoNode, 0, 1, {{0, 0}, {30, 0}, {30, 10}, {0, 10}});
  return tree;
}

TEST(HullsLayer, WritesANodeAFeatureInEveryFormat) {
  const auto city = cityOf(2, "EPSG:25832", {458880, 5438360, 0});
  const ClusterTree tree = treeOf(*city);
  const fs::path place = folder("hulls");
  for (const char* name : {"hulls.geojson", "hulls.gpkg", "hulls.shp", "hulls.fgb"}) {
    const auto result = writeHulls(*city, tree, place / name);
    ASSERT_TRUE(result.ok()) << name << format(result.diagnostics.front());
    EXPECT_EQ(result->files.front(), place / name);
    const GdalErrors errors;
    const DatasetPtr dataset = openVector((place / name).string());
    ASSERT_TRUE(dataset) << name;
    OGRLayer* layer = dataset->GetLayer(0);
    ASSERT_EQ(layer->GetFeatureCount(), 3) << name;
    std::vector<double> parents(3);
    double area = 0;
    for (const auto& feature : *layer) {
      parents.at(static_cast<std::size_t>(feature->GetFieldAsInteger("node"))) =
          feature->GetFieldAsDouble("parent");
      for (const char* field : {"size", "edges", "area", "negative", "height", "base", "max_top"}) {
        EXPECT_TRUE(feature->IsFieldSetAndNotNull(feature->GetFieldIndex(field))) << name << field;
      }
      if (feature->GetFieldAsInteger("node") == 1) {
        EXPECT_EQ(feature->GetFieldAsString("building"), city->buildings[1].object.id);
      }
      area += feature->GetGeometryRef()->toPolygon()->get_Area();
    }
    EXPECT_THAT(parents, ::testing::ElementsAre(2, 2, -1)) << name;
    EXPECT_NEAR(area, 500, 1e-6);
  }
}

TEST(HullsLayer, RefusesAnEndingNobodyWrites) {
  const auto city = cityOf(2, "EPSG:25832", Vec3::Zero());
  const auto result = writeHulls(*city, treeOf(*city), folder("ending") / "hulls.nothing");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.diagnostics.front().code, Code::OutputFormatUnknown);
}

}  // namespace
}  // namespace lodestone
