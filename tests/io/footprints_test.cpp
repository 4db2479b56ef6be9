#include "model/io/footprints/footprints.h"

#include <random>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "model/io/atomic_file.h"
#include "model/io/footprints/deckgl_buildings.h"
#include "model/io/footprints/footprint_layers.h"
#include "model/io/footprints/vector_layer.h"
#include "model/io/gdal_support.h"
#include "model/io/input_file.h"
#include "model/io/read_city.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

std::vector<Code> codes(const Diagnostics& diagnostics) {
  std::vector<Code> result;
  for (const Diagnostic& diagnostic : diagnostics) result.push_back(diagnostic.code);
  return result;
}

class FootprintFiles : public ::testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& text) {
    const fs::path path = fs::path(::testing::TempDir()) / "footprints" / name;
    writeFile(path, text);
    return path;
  }
  static std::string collection(const std::string& features) {
    return R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}},"features":[)" +
           features + "]}";
  }
  static std::string feature(const std::string& properties, const std::string& geometry,
                             const std::string& id = "") {
    return R"({"type":"Feature",)" + (id.empty() ? "" : "\"id\":" + id + ",") +
           "\"properties\":" + properties + ",\"geometry\":" + geometry + "}";
  }
  static constexpr const char* kSquare =
      R"({"type":"Polygon","coordinates":[[[458880,5438360],[458890,5438360],[458890,5438370],[458880,5438370],[458880,5438360]]]})";
  static Result<CityModel> read(const fs::path& path, const ImportOptions& options = {}) {
    return footprintFormat().read(path, options, {});
  }
};

TEST_F(FootprintFiles, KeepAttributesAndTheirTypes) {
  const Result<CityModel> result =
      read(write("types.geojson",
                 collection(feature(R"({"id":"x","n":3,"r":2.5,"t":"Straße","b":true,"l":[1,2],"none":null})",
                                    kSquare))));
  ASSERT_TRUE(result.ok());
  const CityObject& object = result->buildings.at(0).object;
  EXPECT_EQ(object.id, "x");
  EXPECT_EQ(*object.attributes.find("n"), AttributeValue(std::int64_t{3}));
  EXPECT_EQ(*object.attributes.find("r"), AttributeValue(2.5));
  EXPECT_EQ(*object.attributes.find("t"), AttributeValue(std::string("Straße")));
  EXPECT_EQ(*object.attributes.find("b"), AttributeValue(true));
  EXPECT_TRUE(std::holds_alternative<JsonText>(*object.attributes.find("l")));
  EXPECT_EQ(object.attributes.find("none"), nullptr);
  EXPECT_EQ(result->crs.source, "EPSG:25832");
}

TEST_F(FootprintFiles, IdsAreTheFeaturesOwnElseAPropertyElseTheIndex) {
  const auto firstId = [&](const std::string& properties, const std::string& id) {
    const Result<CityModel> result = read(write("ids.geojson", collection(feature(properties, kSquare, id))));
    return result->buildings.at(0).object.id;
  };
  EXPECT_EQ(firstId("{}", ""), "0");
  EXPECT_EQ(firstId("{}", "17"), "17");
  EXPECT_EQ(firstId("{}", "\"own\""), "own");
  EXPECT_EQ(firstId(R"({"gml_id":"g"})", ""), "g");
  EXPECT_EQ(firstId(R"({"gml:id":"h","name":"n"})", ""), "h");
  EXPECT_THAT(codes(read(write("ids.geojson", collection(feature("{}", kSquare)))).diagnostics),
              Contains(Code::IdMissing));
}

TEST_F(FootprintFiles, SayWhatIsMissing) {
  const fs::path path = write("one.geojson", collection(feature(R"({"id":"x","h":3})", kSquare)));
  ImportOptions field;
  field.height = "Höhe";
  EXPECT_THAT(codes(read(path, field).diagnostics), ElementsAre(Code::FieldMissing));
  ImportOptions floors;
  floors.floors = "nothing";
  EXPECT_THAT(codes(read(path, floors).diagnostics), ElementsAre(Code::FieldMissing));
  ImportOptions layer;
  layer.layer = "nothing";
  EXPECT_THAT(codes(read(path, layer).diagnostics), ElementsAre(Code::LayerMissing));
  EXPECT_THAT(codes(read(write("none.geojson", collection(feature(R"({"id":"x"})", kSquare)))).diagnostics),
              ElementsAre(Code::HeightMissing));
  EXPECT_THAT(
      codes(
          read(write("zero.geojson", collection(feature(R"({"id":"x","height":0})", kSquare)))).diagnostics),
      ElementsAre(Code::HeightNotPositive));
}

TEST_F(FootprintFiles, LeaveOutWhatIsNoOutline) {
  const Result<CityModel> result = read(write(
      "mixed.geojson",
      collection(
          feature(R"({"id":"good","height":3})", kSquare) + "," + feature(R"({"id":"empty"})", "null") + "," +
          feature(R"({"id":"point"})", R"({"type":"Point","coordinates":[458880,5438360]})") + "," +
          feature(
              R"({"id":"flat"})",
              R"({"type":"Polygon","coordinates":[[[458880,5438360],[458890,5438370],[458895,5438375],[458880,5438360]]]})"))));
  ASSERT_TRUE(result.ok());
  ASSERT_EQ(result->buildings.size(), 1U);
  EXPECT_EQ(result->buildings[0].object.id, "good");
  for (const Code code :
       {Code::GeometryEmpty, Code::GeometryUnsupported, Code::RingZeroArea, Code::FootprintInvalid}) {
    EXPECT_THAT(codes(result.diagnostics), Contains(code));
  }
}

TEST_F(FootprintFiles, TheGroundOfAnOutlineIsItsZ) {
  const auto at = [&](double low, double high, const std::string& properties) {
    const std::string geometry = R"({"type":"Polygon","coordinates":[[[458880,5438360,)" +
                                 std::to_string(low) + "],[458890,5438360," + std::to_string(low) +
                                 "],[458890,5438370," + std::to_string(high) + "],[458880,5438360," +
                                 std::to_string(low) + "]]]}";
    return read(write("ground.geojson", collection(feature(properties, geometry))))->buildings.at(0);
  };
  EXPECT_EQ(at(110, 111, R"({"height":8})").base, 110);
  EXPECT_EQ(at(110, 111, R"({"height":8})").height, 8);
  EXPECT_EQ(at(110, 111, "{}").heightSource, HeightSource::Default);  // a slope, not a house
  EXPECT_EQ(at(110, 118, "{}").height, 8);
  EXPECT_EQ(at(110, 118, "{}").heightSource, HeightSource::Geometry);
}

TEST_F(FootprintFiles, BodiesKeepTheirSurfaces) {
  const std::string box = R"({"type":"MultiPolygon","coordinates":[
    [[[0,0,5],[10,0,5],[10,10,5],[0,10,5],[0,0,5]]], [[[0,0,0],[10,0,0],[10,0,5],[0,0,5],[0,0,0]]],
    [[[10,0,0],[10,10,0],[10,10,5],[10,0,5],[10,0,0]]]]})";
  const Result<CityModel> result = read(write("body.geojson", collection(feature(R"({"id":"x"})", box))));
  ASSERT_TRUE(result.ok());
  const Building& building = result->buildings.at(0);
  EXPECT_TRUE(building.footprint.empty());  // left to assignFootprints()
  ASSERT_EQ(building.object.geometries.size(), 1U);
  EXPECT_EQ(building.object.geometries[0].surfaceCount(), 3U);
}

TEST_F(FootprintFiles, GeoJsonInMetresWithoutASystemIsNotInDegrees) {
  const Result<CityModel> result = read(
      write("metres.geojson", R"({"type":"FeatureCollection","features":[)" + feature("{}", kSquare) + "]}"));
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->crs.source, "");
}

TEST_F(FootprintFiles, OsmGivesAreasTaggedBuilding) {
  const char* text = R"(<?xml version="1.0"?><osm version="0.6">
<node id="1" lat="49.0" lon="8.0"/><node id="2" lat="49.0" lon="8.001"/><node id="3" lat="49.001" lon="8.001"/><node id="4" lat="49.001" lon="8.0"/>
<node id="5" lat="49.0002" lon="8.0002"/><node id="6" lat="49.0002" lon="8.0004"/><node id="7" lat="49.0004" lon="8.0004"/><node id="8" lat="49.0004" lon="8.0002"/>
<way id="10"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/><tag k="building" v="yes"/><tag k="height" v="16'"/><tag k="roof:shape" v="gabled"/><tag k="min_height" v="2"/></way>
<way id="11"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="8"/><nd ref="5"/><tag k="building" v="no"/></way>
<way id="12"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="8"/><nd ref="5"/><tag k="building:part" v="yes"/></way>
<way id="13"><nd ref="1"/><nd ref="3"/><tag k="highway" v="service"/></way>
<way id="14"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="8"/><nd ref="5"/></way>
<way id="15"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/></way>
<relation id="20"><member type="way" ref="15" role="outer"/><member type="way" ref="14" role="inner"/><tag k="type" v="multipolygon"/><tag k="building" v="school"/><tag k="building:levels" v="3"/></relation>
</osm>)";
  const fs::path path = write("town.osm", text);
  EXPECT_EQ(formatForReading(path)->id, "footprints");
  const Result<CityModel> result = read(path);
  ASSERT_TRUE(result.ok());
  ASSERT_EQ(result->buildings.size(), 2U);
  const auto find = [&](const std::string& id) {
    return std::find_if(result->buildings.begin(), result->buildings.end(),
                        [&](const Building& b) { return b.object.id == id; });
  };
  const auto way = find("way/10");
  ASSERT_NE(way, result->buildings.end());
  EXPECT_NEAR(way->height, 16 * 0.3048, 1e-12);
  EXPECT_EQ(way->object.attributes.text("roof:shape"), "gabled");
  EXPECT_EQ(way->object.attributes.text("min_height"), "2");
  const auto relation = find("relation/20");
  ASSERT_NE(relation, result->buildings.end());
  EXPECT_EQ(relation->height, 9);
  EXPECT_EQ(relation->footprint.at(0).holes.size(), 1U);
  EXPECT_THAT(codes(result.diagnostics), Contains(Code::ObjectSkipped));  // the part
  EXPECT_THAT(codes(result.diagnostics), Not(Contains(Code::FieldMissing)));

  ImportOptions tags;
  tags.height = "height";  // one of the two has it
  EXPECT_THAT(codes(read(path, tags).diagnostics), Not(Contains(Code::FieldMissing)));
  tags.floors = "levels";
  const Result<CityModel> mistyped = read(path, tags);
  EXPECT_TRUE(mistyped.ok());
  EXPECT_THAT(codes(mistyped.diagnostics), Contains(Code::FieldMissing));
}

TEST_F(FootprintFiles, ABrokenMemberOfAnArchiveIsSaid) {
  const fs::path path = write("tiles.zip", {});
  fs::remove(path);
  const std::string root = "/vsizip/{" + path.string() + "}/";
  VSILFILE* holder = VSIFOpenL(root.c_str(), "wb");  // keeps the archive open for all members
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"a.geojson", collection(feature(R"({"h":3})", kSquare))},
        {"b.geojson", collection(feature(R"({"other":3})", kSquare))},
        {"c.geojson", "{\"type\":\"FeatureCollection\","}}) {
    VSILFILE* file = VSIFOpenL((root + name).c_str(), "wb");
    VSIFWriteL(text.data(), 1, text.size(), file);
    VSIFCloseL(file);
  }
  VSIFCloseL(holder);
  ImportOptions options;
  options.height = "h";
  const Result<CityModel> result = read(path, options);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->buildings.size(), 1U);
  EXPECT_EQ(result->buildings.at(0).source, 0U);
  EXPECT_EQ(result->sources.size(), 1U);
  EXPECT_THAT(codes(result.diagnostics), Contains(Code::FieldMissing));
  EXPECT_THAT(codes(result.diagnostics), Contains(Code::FileMalformed));
}

TEST_F(FootprintFiles, ProbesTellJsonFormatsApart) {
  const Format format = footprintFormat();
  EXPECT_GT(format.probe("a.json", R"({"type":"FeatureCollection","features":[)"), 50);
  EXPECT_GT(format.probe("a.json", R"([{"height":3,"polygon":[[1,2]]}])"), 50);
  EXPECT_EQ(format.probe("a.json", R"({"type":"CityJSON","version":"2.0"})"), 0);
  EXPECT_EQ(format.probe("a.jsonl", R"({"type":"CityJSONFeature","id":"x"})"), 0);
  EXPECT_EQ(format.probe("a.json", R"({"anything":1})"), 0);
  EXPECT_EQ(format.probe("a.gml", "<CityModel>"), 0);
  EXPECT_EQ(format.probe("a.gpkg", std::string("SQLite format 3\0abc", 19)), 100);
  EXPECT_EQ(format.probe("a.shp", std::string("\0\0\x27\x0a\0\0", 6)), 100);
}

TEST_F(FootprintFiles, BrokenFilesAreSaid) {
  const std::string good = collection(feature(R"({"id":"x","height":3})", kSquare));
  for (std::size_t length = 1; length < good.size(); length += 7) {
    const Result<CityModel> result = read(write("cut.geojson", good.substr(0, length)));
    EXPECT_TRUE(result.ok() || !result.diagnostics.empty()) << length;
  }
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    std::string noisy = good;
    for (int k = 0; k < 5; ++k) noisy[random() % noisy.size()] = static_cast<char>(random() % 256);
    (void)read(write("noisy.geojson", noisy));
  }
  for (const char* name : {"bad.shp", "bad.gpkg", "bad.fgb", "bad.osm.pbf", "bad.osm"}) {
    const Result<CityModel> result = read(write(name, std::string("\0\0\x27\x0a no shape", 14)));
    EXPECT_FALSE(result.ok()) << name;
    EXPECT_THAT(codes(result.diagnostics), ElementsAre(Code::FileMalformed)) << name;
  }
}

TEST(Tags, AreParsedFromHstore) {
  const Attributes tags = parseTags(R"("a"=>"b","quote"=>"say \"x\"","back"=>"c:\\d","empty"=>"")");
  EXPECT_EQ(tags.size(), 4U);
  EXPECT_EQ(tags.text("quote"), "say \"x\"");
  EXPECT_EQ(tags.text("back"), "c:\\d");
  for (const char* broken : {"", "\"", "\"a", "\"a\"=>", "\"a\"=>\"b", "\\"}) (void)parseTags(broken);
}

TEST(DeckGl, ArraysOfPolygons) {
  EXPECT_TRUE(looksLikeDeckGl(" [{\"height\": 1, \"polygon\": []}]"));
  const auto parsed = parseDeckGl(
      R"([{"height":12,"polygon":[[0,0],[1,0],[1,1]]},{"polygon":[[[0,0],[9,0],[9,9]],[[5,1],[6,1],[6,2]]],"id":"b"},{"x":1}])");
  ASSERT_TRUE(parsed.ok());
  ASSERT_EQ((*parsed).size(), 2U);
  EXPECT_EQ((*parsed)[0].object.attributes.number("height"), 12);
  EXPECT_EQ((*parsed)[1].footprint[0].holes.size(), 1U);
  EXPECT_EQ((*parsed)[1].object.id, "b");
  EXPECT_FALSE(parseDeckGl("[{").ok());
  EXPECT_FALSE(parseDeckGl("{}").ok());
}

// ---- layers

/// A GeoPackage of streets, parcels and buildings, one square each.
fs::path threeLayers() {
  const fs::path path = fs::path(::testing::TempDir()) / "three_layers.gpkg";
  fs::remove(path);
  useGdal();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  const DatasetPtr dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  const auto add = [&](const char* name, OGRwkbGeometryType type, const std::vector<const char*>& shapes) {
    OGRLayer* layer = dataset->CreateLayer(name, nullptr, type, nullptr);
    for (const char* wkt : shapes) {
      OGRFeature feature(layer->GetLayerDefn());
      OGRGeometry* geometry = nullptr;
      OGRGeometryFactory::createFromWkt(wkt, nullptr, &geometry);
      feature.SetGeometryDirectly(geometry);
      EXPECT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    }
  };
  add("streets", wkbLineString, {"LINESTRING (0 0, 80 0)", "LINESTRING (0 0, 0 80)"});
  add("parcels", wkbPolygon, {"POLYGON ((0 0, 90 0, 90 90, 0 90, 0 0))"});
  add("Buildings", wkbPolygon, {"POLYGON ((5 5, 25 5, 25 25, 5 25, 5 5))"});
  return path;
}

TEST(Layers, TheOneThatSpeaksOfBuildingsIsReadAndSaid) {
  const Result<CityModel> read = footprintFormat().read(threeLayers(), {}, {});
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->sources.at(0).title, "Buildings");
  const auto said = std::find_if(read.diagnostics.begin(), read.diagnostics.end(),
                                 [](const Diagnostic& d) { return d.code == Code::LayerChosen; });
  ASSERT_NE(said, read.diagnostics.end());
  EXPECT_THAT(said->text, ::testing::HasSubstr("Buildings of parcels, Buildings"));
  ImportOptions parcels;
  parcels.layer = "parcels";
  const Result<CityModel> named = footprintFormat().read(threeLayers(), parcels, {});
  ASSERT_TRUE(named.ok());
  EXPECT_EQ(named->sources.at(0).title, "parcels");
  EXPECT_THAT(codes(named.diagnostics), Not(Contains(Code::LayerChosen)));
}

TEST(Layers, AreListedWithGeometryAndCount) {
  const std::vector<LayerEntry> layers = listLayers(threeLayers(), {});
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0].name, "streets");
  EXPECT_EQ(layers[0].geometry, "Line String");
  EXPECT_EQ(layers[0].features, 2);
  EXPECT_FALSE(layers[0].read);
  EXPECT_EQ(layers[2].name, "Buildings");
  EXPECT_EQ(layers[2].geometry, "Polygon");
  EXPECT_TRUE(layers[2].read);
  EXPECT_TRUE(listLayers(fs::path(::testing::TempDir()) / "no_layers.gpkg", {}).empty());
}

TEST(Layers, OfOsmAreCounted) {
  const fs::path path = test::sharedData("C_footprints/plateau_osm_heights/53395403_bldg_6697_op.osm");
  if (path.empty()) GTEST_SKIP() << "shared data not present";
  const std::vector<LayerEntry> layers = listLayers(path, {});
  ASSERT_EQ(layers.size(), 5U);
  EXPECT_EQ(layers[3].name, "multipolygons");
  EXPECT_TRUE(layers[3].read);
  EXPECT_GE(layers[3].features, 1167);
  ImportOptions lines;
  lines.layer = "lines";
  EXPECT_THAT(codes(footprintFormat().read(path, lines, {}).diagnostics), Contains(Code::LayerMissing));
}

TEST(Layers, OneOfSeveralGivesTheBarriers) {
  const Result<CityModel> city = readCity({threeLayers()});
  ASSERT_TRUE(city.ok());
  const auto taken = [&](const std::string& layer) {
    const Result<LineLayer> lines = readLines(threeLayers(), *city, layer);
    std::string text = lines ? fmt::format("{} rings; ", lines->lines.size()) : "";
    for (const Diagnostic& d : lines.diagnostics)
      text += fmt::format("{} {};", static_cast<int>(d.code), d.text);
    return text;
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(taken({}),
              AllOf(HasSubstr("2 rings"), HasSubstr("2 lines of layer streets of three_layers.gpkg")));
  EXPECT_THAT(taken("parcels"),
              AllOf(HasSubstr("1 rings"), HasSubstr("the outlines of 1 polygons of layer parcels")));
  EXPECT_THAT(taken("rivers"), HasSubstr("layer not found: rivers is not among streets, parcels, Buildings"));
}

}  // namespace
}  // namespace lodestone
