#include "model/io/cityjson/cityjson_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "model/io/cityjson/cityjson_geometry.h"
#include "model/io/format.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

Result<CityModel> parse(const std::string& text) {
  return parseCityJson(text, "test.city.json", "cityjson");
}
bool says(const Diagnostics& diagnostics, Code code) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [&](const Diagnostic& d) { return d.code == code; });
}

const std::string kTransform = R"("transform":{"scale":[0.001,0.001,0.001],"translate":[100,200,10]})";
const std::string kVertices =
    R"("vertices":[[0,0,0],[1000,0,0],[1000,1000,0],[0,1000,0],[0,0,3000],[1000,0,3000],[1000,1000,3000],[0,1000,3000]])";

std::string document(const std::string& objects, const std::string& more = {}) {
  return R"({"type":"CityJSON","version":"2.0",)" + kTransform + "," + kVertices + more +
         R"(,"CityObjects":{)" + objects + "}}";
}
std::string building(const std::string& geometry) {
  return R"("b":{"type":"Building","geometry":[)" + geometry + "]}";
}

TEST(CityJsonReader, TransformsAndKeepsLodSemanticsAndAttributes) {
  const auto city = parse(document(
      R"("b":{"type":"Building","attributes":{"height":5.0,"floors":2,"name":"\u00e9","on":true,"list":[1, 2],"gone":null,
          "big":18446744073709551615},"address":[{"city":"X","location":{"type":"MultiPoint","lod":"1","boundaries":[0]}}],
        "geometry":[{"type":"MultiSurface","lod":"2.2","boundaries":[[[0,3,2,1]],[[0,1,5,4]]],
        "semantics":{"surfaces":[{"type":"GroundSurface"},{"type":"WallSurface"}],"values":[0,null]}}]})",
      R"(,"metadata":{"referenceSystem":"https://www.opengis.net/def/crs/EPSG/0/7415","title":"T"})"));
  ASSERT_TRUE(city);
  EXPECT_TRUE(city.diagnostics.empty());
  EXPECT_EQ(city->crs.source, "https://www.opengis.net/def/crs/EPSG/0/7415");
  EXPECT_EQ(city->sources.at(0).title, "T");
  EXPECT_EQ(city->sources.at(0).version, "2.0");
  ASSERT_EQ(city->buildings.size(), 1U);
  const CityObject& object = city->buildings[0].object;
  EXPECT_EQ(*object.attributes.find("height"), AttributeValue(5.0));
  EXPECT_EQ(*object.attributes.find("floors"), AttributeValue(std::int64_t{2}));
  EXPECT_EQ(*object.attributes.find("name"), AttributeValue(std::string("é")));
  EXPECT_EQ(*object.attributes.find("on"), AttributeValue(true));
  EXPECT_EQ(*object.attributes.find("list"), AttributeValue(JsonText{"[1,2]"}));
  EXPECT_EQ(*object.attributes.find("gone"), AttributeValue(JsonText{"null"}));
  EXPECT_EQ(*object.attributes.find("big"), AttributeValue(JsonText{"18446744073709551615"}));
  EXPECT_EQ(*object.attributes.find("address"), AttributeValue(JsonText{R"([{"city":"X"}])"}));
  const Geometry& geometry = object.geometries.at(0);
  EXPECT_EQ(geometry.lod, "2.2");
  EXPECT_EQ(geometry.surfaces.at(0).type, SurfaceType::Ground);
  EXPECT_EQ(geometry.surfaces.at(1).type, SurfaceType::Unknown);
  EXPECT_EQ(geometry.vertices.at(2), Vec3(101, 201, 10));
  EXPECT_EQ(geometry.ringStart, (std::vector<std::uint32_t>{0, 4, 8}));
}

TEST(CityJsonReader, NestedSolidsKeepShellsAndSemantics) {
  const auto city = parse(document(building(
      R"({"type":"MultiSolid","lod":"2","boundaries":[[[[[0,1,2]],[[0,2,3]]],[[[4,5,6]]]],[[[[1,2,6]]]]],
          "semantics":{"surfaces":[{"type":"RoofSurface"},{"type":"Door"}],"values":[[[0,1],null],[[1]]]}})")));
  ASSERT_TRUE(city);
  const Geometry& geometry = city->buildings.at(0).object.geometries.at(0);
  EXPECT_EQ(geometry.shellStart, (std::vector<std::uint32_t>{0, 2, 3, 4}));
  EXPECT_EQ(geometry.solidStart, (std::vector<std::uint32_t>{0, 2, 3}));
  std::vector<SurfaceType> types;
  for (const SurfaceInfo& info : geometry.surfaces) types.push_back(info.type);
  EXPECT_EQ(types,
            (std::vector{SurfaceType::Roof, SurfaceType::Door, SurfaceType::Unknown, SurfaceType::Door}));
}

TEST(CityJsonReader, AppearanceOfTheFirstTheme) {
  const auto city = parse(document(
      building(
          R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2,0]],[[0,2,3]]],
              "material":{"a":{"values":[1,null]},"b":{"value":0}},
              "texture":{"a":{"values":[[[0,0,1,2,0]],[[null]]]}}})"),
      R"(,"appearance":{"materials":[{"name":"m0"},{"name":"m1","diffuseColor":[0.25,0.5,1],"shininess":0.5}],
          "textures":[{"type":"PNG","image":"gone.png","wrapMode":"wrap"}],"vertices-texture":[[0,0],[1,0],[1,1]]})"));
  ASSERT_TRUE(city);
  EXPECT_TRUE(says(city.diagnostics, Code::TextureMissing));
  EXPECT_EQ(city->materials.at(1).diffuse, (std::array<float, 3>{0.25F, 0.5F, 1.0F}));
  EXPECT_EQ(city->materials.at(1).json, R"({"shininess":0.5})");
  EXPECT_TRUE(city->textures.at(0).missing);
  const Geometry& geometry = city->buildings.at(0).object.geometries.at(0);
  EXPECT_EQ(geometry.surfaces.at(0).material, 1);
  EXPECT_EQ(geometry.surfaces.at(1).material, -1);
  EXPECT_EQ(geometry.surfaces.at(0).texture, 0);
  EXPECT_EQ(geometry.surfaces.at(1).texture, -1);
  ASSERT_EQ(geometry.textureCoordinates.size(), geometry.ringVertices.size());
  EXPECT_EQ(geometry.textureCoordinates.at(2), Vec2f(1, 1));
  EXPECT_TRUE(std::isnan(geometry.textureCoordinates.at(3).x()));
}

TEST(CityJsonReader, TemplatesArePlacedAndMirroredOnesTurned) {
  const std::string templates =
      R"(,"geometry-templates":{"vertices-templates":[[0,0,0],[1,0,0],[0,1,0]],
          "templates":[{"type":"MultiSurface","lod":"3","boundaries":[[[0,1,2]]]}]})";
  const auto place = [&](const std::string& matrix) {
    return parse(document(
        R"("t":{"type":"SolitaryVegetationObject","geometry":[{"type":"GeometryInstance","template":0,
        "boundaries":[1],"transformationMatrix":)" +
            matrix + "}]}",
        templates));
  };
  const auto moved = place("[2,0,0,0, 0,2,0,0, 0,0,2,5, 0,0,0,1]");
  ASSERT_TRUE(moved);
  const Geometry& geometry = moved->others.at(0).geometries.at(0);
  EXPECT_EQ(geometry.vertices, (std::vector<Vec3>{{101, 200, 15}, {103, 200, 15}, {101, 202, 15}}));
  const auto mirrored = place("[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]");
  EXPECT_EQ(mirrored->others.at(0).geometries.at(0).ringVertices, (std::vector<std::uint32_t>{2, 1, 0}));
  EXPECT_TRUE(says(place("[1,0]").diagnostics, Code::CoordinateBad));
}

// A small file may not fill the memory by placing one template again and again.
TEST(CityJsonReader, TemplatesArePlacedUpToABound) {
  Geometry triangle;
  triangle.addRing({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  triangle.finishSurface();
  const std::vector<Geometry> templates{triangle};
  PlacedTemplates placed(5);
  CityJsonContext context;
  context.vertices = {Vec3::Zero()};
  context.templates = &templates;
  context.placed = &placed;
  CityJsonGeometryReader reader(context);
  simdjson::dom::parser parser;
  const simdjson::padded_string text = std::string(
      R"({"type":"GeometryInstance","template":0,"boundaries":[0],"transformationMatrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})");
  const JsonObject instance = parser.parse(text);
  ObjectDiagnostics said;
  EXPECT_EQ(reader.read(instance, said).surfaceCount(), 1U);
  EXPECT_EQ(reader.read(instance, said).surfaceCount(), 1U);
  EXPECT_EQ(reader.read(instance, said).surfaceCount(), 0U) << "6 vertices are placed already";
  Diagnostics diagnostics;
  said.flush("tree", diagnostics);
  EXPECT_TRUE(says(diagnostics, Code::CountImplausible));
}

TEST(CityJsonReader, BuildsTheTreeFromEitherDirection) {
  const auto city = parse(document(
      R"("part2":{"type":"BuildingPart","parents":["b"]},"b":{"type":"Building","children":["part1"]},
         "part1":{"type":"BuildingPart"},"room":{"type":"BuildingRoom","parents":["part1"]},
         "orphan":{"type":"BuildingPart","parents":["nobody"]},"g":{"type":"CityObjectGroup","children":["b"]},
         "x":{"type":"+Noise","colour":"red"},"c1":{"type":"Bridge","parents":["c2"]},"c2":{"type":"Bridge","parents":["c1"]})"));
  ASSERT_TRUE(city);
  ASSERT_EQ(city->buildings.size(), 2U);
  const CityObject& b =
      city->buildings[0].object.id == "b" ? city->buildings[0].object : city->buildings[1].object;
  ASSERT_EQ(b.children.size(), 2U);
  EXPECT_EQ(b.children[0].id, "part2");
  EXPECT_EQ(b.children[1].id, "part1");
  EXPECT_EQ(b.children[1].children.at(0).id, "room");
  EXPECT_TRUE(says(city.diagnostics, Code::ParentMissing));
  ASSERT_EQ(city->others.size(),
            3U);  // the group, the extension's object, one of the two that own each other
  const auto noise =
      std::find_if(city->others.begin(), city->others.end(), [](const auto& o) { return o.id == "x"; });
  ASSERT_NE(noise, city->others.end());
  EXPECT_EQ(noise->type, ObjectType::Other);
  EXPECT_EQ(noise->attributes.text("cityjson:type"), "+Noise");
  EXPECT_EQ(noise->attributes.text("colour"), "\"red\"");
}

TEST(CityJsonReader, ChainsOfParentsAreBounded) {
  std::string objects = R"("o0":{"type":"BuildingPart"})";
  for (int i = 1; i < 3000; ++i) {
    objects += ",\"o" + std::to_string(i) + R"(":{"type":"BuildingPart","parents":["o)" +
               std::to_string(i - 1) + "\"]}";
  }
  const auto city = parse(document(objects));
  ASSERT_TRUE(city);
  EXPECT_TRUE(says(city.diagnostics, Code::NestingTooDeep));
  std::size_t count = 0;
  forEachObjectOf(*city, [&](const CityObject&) { ++count; });
  EXPECT_EQ(count, 3000U);
}

struct BrokenCase {
  const char* name;
  std::string text;
  Code code;
  std::size_t buildings;  ///< that are imported all the same
};
std::string surfaces(const std::string& boundaries, const std::string& more = {}) {
  return document(building(R"({"type":"MultiSurface","lod":"1","boundaries":)" + boundaries + more + "}"));
}
std::vector<BrokenCase> brokenCases() {
  const std::string good =
      document(building(R"({"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]})"));
  const auto cut = [&](double share) {
    return good.substr(0, static_cast<std::size_t>(share * static_cast<double>(good.size())));
  };
  return {
      {"IndexTooGreat", surfaces("[[[0,1,2]],[[0,1,99]]]"), Code::IndexOutOfRange, 1},
      {"IndexNegative", surfaces("[[[0,1,2]],[[0,1,-1]]]"), Code::IndexOutOfRange, 1},
      {"IndexNotInteger", surfaces("[[[0,1,2]],[[0,1,2.5]]]"), Code::IndexOutOfRange, 1},
      {"RingTooShort", surfaces("[[[0,1,2]],[[0,1,0]]]"), Code::RingTooShort, 1},
      {"HoleTooShort", surfaces("[[[0,1,2],[0,1]]]"), Code::HoleDropped, 1},
      {"NestingWrong", surfaces("[[0,1,2]]"), Code::GeometryUnsupported, 1},
      {"BoundariesMissing", surfaces("null"), Code::GeometryEmpty, 1},
      {"TypeUnknown", document(building(R"({"type":"Sphere","lod":"1"})")), Code::GeometryUnsupported, 1},
      {"SemanticIndex", surfaces("[[[0,1,2]]]", R"(,"semantics":{"surfaces":[],"values":[3]})"),
       Code::SemanticsBad, 1},
      {"MaterialIndex", surfaces("[[[0,1,2]]]", R"(,"material":{"t":{"value":3}})"), Code::AppearanceBad, 1},
      {"TextureIndex", surfaces("[[[0,1,2]]]", R"(,"texture":{"t":{"values":[[[0,1,2,3]]]}})"),
       Code::TextureBad, 1},
      {"TemplateAbsent", document(building(R"({"type":"GeometryInstance","template":0,"boundaries":[0]})")),
       Code::TemplateMissing, 1},
      {"VertexNotNumber",
       R"({"type":"CityJSON","version":"1.0","vertices":[[0,0,0],[1,0,0],["x",1,0]],"CityObjects":{)" +
           building(R"({"type":"MultiSurface","lod":1,"boundaries":[[[0,1,2]]]})") + "}}",
       Code::CoordinateBad, 1},
      {"NoType", document(R"("b":{"type":"Building"},"c":{})"), Code::ObjectSkipped, 1},
      {"SameId", document(R"("b":{"type":"Building"},"b":{"type":"Building"})"), Code::DuplicateId, 2},
      {"FutureVersion",
       R"({"type":"CityJSON","version":"9.0","vertices":[],"CityObjects":{"b":{"type":"Building"}}})",
       Code::VersionUnsupported, 1},
      {"TransformMissing",
       R"({"type":"CityJSON","version":"2.0","vertices":[],"CityObjects":{"b":{"type":"Building"}}})",
       Code::TransformMissing, 1},
      {"TransformBroken",
       R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1]},"vertices":[],"CityObjects":{"b":{"type":"Building"}}})",
       Code::FileMalformed, 1},
      {"ByteOrderMark", "\xEF\xBB\xBF" + good, Code::ByteOrderMark, 1},
      {"NotCityJson", R"({"type":"FeatureCollection"})", Code::FileMalformed, 0},
      {"TypeMissing", R"({"version":"2.0","CityObjects":{},"vertices":[]})", Code::FileMalformed, 0},
      {"Truncated", cut(0.5), Code::FileTruncated, 0},
      {"TruncatedInText", cut(0.05), Code::FileTruncated, 0},
      {"Empty", "  \n", Code::FileEmpty, 0},
      {"NotUtf8", "{\"type\":\"City\xFFJSON\"}", Code::EncodingBad, 0},
      {"Utf16", std::string("\xFF\xFE{\0}\0", 6), Code::EncodingBad, 0},
      {"DeepNesting", std::string(5000, '[') + std::string(5000, ']'), Code::NestingTooDeep, 0},
      {"NumberTooGreat", R"({"type":"CityJSON","version":"2.0","vertices":[[1e999,0,0]],"CityObjects":{}})",
       Code::FileMalformed, 0},
      {"NaN", R"({"type":"CityJSON","version":"2.0","vertices":[[NaN,0,0]],"CityObjects":{}})",
       Code::FileMalformed, 0},
  };
}

class Broken : public testing::TestWithParam<BrokenCase> {};
TEST_P(Broken, IsSaidAndTheRestIsImported) {
  const auto city = parse(GetParam().text);
  EXPECT_TRUE(says(city.diagnostics, GetParam().code));
  EXPECT_EQ(city ? city->buildings.size() : 0, GetParam().buildings);
  for (const Diagnostic& d : city.diagnostics) EXPECT_FALSE(d.text.empty());
}
INSTANTIATE_TEST_SUITE_P(Cases, Broken, testing::ValuesIn(brokenCases()),
                         [](const auto& param) { return std::string(param.param.name); });

// A broken line of a sequence costs that line alone.
TEST(CityJsonReader, SequencesSurviveBrokenLines) {
  const std::string header =
      R"({"type":"CityJSON","version":"2.0",)" + kTransform + R"(,"CityObjects":{},"vertices":[]})";
  const auto feature = [](const std::string& id) {
    return R"({"type":"CityJSONFeature","id":")" + id +
           R"(","vertices":[[0,0,0],[1000,0,0],[0,1000,0]],"CityObjects":{")" + id +
           R"(":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]}]}}})";
  };
  const std::string broken = feature("c").substr(0, 60);
  const auto city =
      parse(header + "\n" + feature("a") + "\r\n\n" + broken + "\n" + feature("b") + "\n" + broken);
  ASSERT_TRUE(city);
  ASSERT_EQ(city->buildings.size(), 2U);
  EXPECT_EQ(city->buildings[1].object.id, "b");
  EXPECT_EQ(city->buildings[0].object.geometries.at(0).vertices.at(0), Vec3(100, 200, 10));
  EXPECT_EQ(std::count_if(city.diagnostics.begin(), city.diagnostics.end(),
                          [](const Diagnostic& d) { return d.code == Code::FileTruncated; }),
            2);
  EXPECT_EQ(city.diagnostics.front().place, "test.city.json:4");
}

TEST(CityJsonReader, AbsentFilesAreSaid) {
  const auto city = readCityJsonDocuments("/nowhere/at/all.city.json", "cityjson", {}, {});
  EXPECT_FALSE(city);
  EXPECT_TRUE(says(city.diagnostics, Code::FileNotFound));
}

struct Expected {
  const char* file;
  std::size_t buildings, parts, surfaces;
};
class SharedCityJson : public testing::TestWithParam<Expected> {};

// Counts as the data's own description gives them, less the surfaces that have no area.
TEST_P(SharedCityJson, HoldsWhatItsDescriptionSays) {
  const auto path = test::sharedData("B_cityjson/" + std::string(GetParam().file));
  if (path.empty()) GTEST_SKIP() << "shared data not present";
  const Format* format = formatForReading(path);
  ASSERT_NE(format, nullptr);
  const auto city = format->read(path, {}, {});
  ASSERT_TRUE(city);
  EXPECT_FALSE(hasErrors(city.diagnostics));
  std::size_t parts = 0;
  std::size_t surfaceCount = 0;
  forEachObjectOf(*city, [&](const CityObject& object) {
    parts += object.type == ObjectType::BuildingPart ? 1 : 0;
    for (const Geometry& geometry : object.geometries) surfaceCount += geometry.surfaceCount();
  });
  EXPECT_EQ(city->buildings.size(), GetParam().buildings);
  EXPECT_EQ(parts, GetParam().parts);
  EXPECT_EQ(surfaceCount, GetParam().surfaces);
}
INSTANTIATE_TEST_SUITE_P(
    Files, SharedCityJson,
    testing::Values(Expected{"denhaag_zip_dtcc/DenHaag_01.city.json.zip", 844, 1653, 21804},
                    Expected{"cjio/delft.json", 160, 0, 36271},
                    Expected{"cjio/zurich/zurich_subset_lod2.json", 49, 161, 2039},
                    Expected{"cjdb/vienna.jsonl", 149, 443, 18814},
                    Expected{"cjio/multi_lod.json", 10, 0, 752},
                    Expected{"capetown_lod1_geo3d/citjsn_sRiver3D.json", 1377, 0, 33649},
                    Expected{"bertt/tests/fixtures/cityjsonseq/montréal_b4.city.jsonl", 4, 0, 552},
                    Expected{"bertt/tests/fixtures/euromast.json", 1, 0, 554},
                    Expected{"duckdb_cityjson/delft_subset.city.jsonl", 10, 10, 335},
                    Expected{"cjval/japanese.city.json", 2, 0, 220}));

TEST(SharedCityJsonCorpus, ConformanceFilesAreReadAndInvalidOnesAreSaid) {
  const auto root = test::sharedData("B_cityjson/corpus_conformance_invalid");
  if (root.empty()) GTEST_SKIP() << "shared data not present";
  std::size_t valid = 0;
  std::size_t invalid = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string name = entry.path().filename().string();
    const bool description = name == "case.json" || name == "invariants.json" || name == "profile.json";
    if (!entry.is_regular_file() || description) continue;
    const auto city = readCityJsonDocuments(entry.path(), "cityjson", {}, {});
    if (name.starts_with("invalid_")) {
      ++invalid;
      EXPECT_FALSE(city.diagnostics.empty()) << name;
    } else {
      ++valid;
      EXPECT_TRUE(city) << name;
      EXPECT_FALSE(hasErrors(city.diagnostics)) << name;
    }
  }
  EXPECT_EQ(invalid, 4U);
  EXPECT_GT(valid, 30U);
}

}  // namespace
}  // namespace lodestone
