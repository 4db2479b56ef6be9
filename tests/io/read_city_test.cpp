#include "model/io/read_city.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include <GeographicLib/Geodesic.hpp>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/io/places/georeference.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;

const fs::path kData = fs::path(LODESTONE_TEST_DATA) / "footprints";

std::vector<Code> codes(const Diagnostics& diagnostics) {
  std::vector<Code> result;
  for (const Diagnostic& diagnostic : diagnostics) result.push_back(diagnostic.code);
  return result;
}

TEST(ReadCity, NeedsAnInput) {
  EXPECT_FALSE(readCity({}).ok());
}

TEST(ReadCity, SaysWhyAFileCannotBeRead) {
  const fs::path folder = fs::path(::testing::TempDir()) / "read_city";
  fs::create_directories(folder);
  EXPECT_THAT(codes(readCity({folder / "none.geojson"}).diagnostics), Contains(Code::FileNotFound));
  EXPECT_THAT(codes(readCity({folder}).diagnostics), Contains(Code::FileUnreadable));
  std::ofstream(folder / "empty.geojson").flush();
  EXPECT_THAT(codes(readCity({folder / "empty.geojson"}).diagnostics), Contains(Code::FileEmpty));
  std::ofstream(folder / "noise.bin") << "neither this nor that";
  EXPECT_THAT(codes(readCity({folder / "noise.bin"}).diagnostics), Contains(Code::FormatUnknown));
}

TEST(ReadCity, OneBadFileDoesNotStopTheOthers) {
  const Result<CityModel> result = readCity({kData / "absent.geojson", kData / "town_utm.geojson"});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->buildings.size(), 3U);
  EXPECT_THAT(codes(result.diagnostics), Contains(Code::InputLeftOut));
}

TEST(ReadCity, SaysOptionsThatNoInputListensTo) {
  const fs::path mesh = fs::path(::testing::TempDir()) / "slab.obj";
  std::ofstream(mesh) << "v 0 0 0\nv 4 0 0\nv 4 4 0\nf 1 2 3\n";
  ImportOptions options;
  options.floors = "levels";
  EXPECT_THAT(codes(readCity({mesh}, options).diagnostics), Contains(Code::OptionUnused));
  options.unit = 0.01;
  EXPECT_THAT(codes(readCity({mesh}, options).diagnostics), Contains(Code::OptionUnused).Times(1));
  const auto both = readCity({mesh, kData / "town_utm.geojson"}, {.unit = 0.01});
  EXPECT_THAT(codes(both.diagnostics), testing::Not(Contains(Code::OptionUnused)));
}

TEST(ReadCity, RefusesAHeightThatIsNone) {
  for (const char* height : {"0", "-3 m"}) {
    const auto result = readCity({kData / "town_utm.geojson"}, {.height = height});
    EXPECT_FALSE(result.ok());
    EXPECT_THAT(codes(result.diagnostics), testing::ElementsAre(Code::OptionOutOfRange));
  }
}

TEST(ReadCity, SaysThatThereAreNoBuildings) {
  const fs::path path = fs::path(::testing::TempDir()) / "nobody.geojson";
  std::ofstream(path) << R"({"type":"FeatureCollection","features":[]})";
  EXPECT_THAT(codes(readCity({path}).diagnostics), Contains(Code::NoBuildings));
}

TEST(ReadCity, KeepsOtherObjectsOfABrokenFile) {
  const fs::path path = fs::path(::testing::TempDir()) / "bridge.gml";
  std::ofstream(path)
      << "<CityModel xmlns='http://www.opengis.net/citygml/2.0' "
         "xmlns:g='http://www.opengis.net/gml' xmlns:f='http://www.opengis.net/citygml/cityfurniture/2.0'>"
         "<cityObjectMember><f:CityFurniture g:id='lamp'/></cityObjectMember><cityObjectMember>";
  const Result<CityModel> result = readCity({path});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->others.size(), 1U);
  EXPECT_THAT(codes(result.diagnostics), Contains(Code::InputReadInPart));
}

/// A vector layer of one house of 20 m (or units), its south-west corner at (x, y).
fs::path houseAt(double x, double y, const std::string& name, const std::string& crs) {
  const fs::path path = fs::path(::testing::TempDir()) / name;
  std::ofstream file(path);
  file << R"({"type":"FeatureCollection",)";
  if (!crs.empty()) file << R"("crs":{"type":"name","properties":{"name":")" << crs << R"("}},)";
  file << fmt::format(
      R"("features":[{{"type":"Feature","properties":{{"height":9}},"geometry":{{"type":"Polygon",
      "coordinates":[[[{0},{1}],[{2},{1}],[{2},{3}],[{0},{3}],[{0},{1}]]]}}}}]}})",
      x, y, x + 20, y + 20);
  return path;
}

TEST(ReadCity, MercatorComesInTrueMetresAndKeepsItsSystem) {
  // In Berlin, at 52.5°, Web Mercator draws a metre 1.64 long.
  const Result<CityModel> berlin =
      readCity({houseAt(1491000, 6894000, "berlin.geojson", "urn:ogc:def:crs:EPSG::3857")});
  ASSERT_TRUE(berlin.ok());
  EXPECT_THAT(codes(berlin.diagnostics), Contains(Code::MercatorStraightened));
  EXPECT_EQ(berlin->crs.epsg, 3857);
  const Vec3 size = bounds(berlin->buildings.at(0)).size();
  const GeographicLib::Geodesic& earth = GeographicLib::Geodesic::WGS84();
  double east = 0;
  double north = 0;
  const Vec2 low(13.3938808862221, 52.5161746434521);  // by gdaltransform
  const Vec2 high(13.3940605492789, 52.5162839750128);
  earth.Inverse(low.y(), low.x(), low.y(), high.x(), east);
  earth.Inverse(low.y(), low.x(), high.y(), low.x(), north);
  EXPECT_NEAR(size.x(), east, 1e-4);
  EXPECT_NEAR(size.y(), north, 1e-4);
  const Vec2 corner = toWorld(*berlin, Vec3(berlin->buildings[0].footprint[0].outer[0].x(),
                                            berlin->buildings[0].footprint[0].outer[0].y(), 0))
                          .head<2>();
  EXPECT_LT((corner - Vec2(1491000, 6894000)).norm(), 1e-6);
}

// Two corners of a city of 10 km, as far apart as on the ellipsoid.
TEST(ReadCity, MercatorIsTrueAcrossACity) {
  const Vec2 a(1483000, 6886000);
  const Vec2 b(1499500, 6902500);
  const std::string crs = "urn:ogc:def:crs:EPSG::3857";
  const Result<CityModel> city = readCity(
      {houseAt(a.x(), a.y(), "southwest.geojson", crs), houseAt(b.x(), b.y(), "northeast.geojson", crs)});
  ASSERT_TRUE(city.ok());
  ASSERT_EQ(city->buildings.size(), 2U);
  constexpr double kRadius = 6378137;
  const auto latitude = [](double y) { return std::atan(std::sinh(y / kRadius)) * 180 / std::numbers::pi; };
  const auto longitude = [](double x) { return x / kRadius * 180 / std::numbers::pi; };
  double expected = 0;
  GeographicLib::Geodesic::WGS84().Inverse(latitude(a.y()), longitude(a.x()), latitude(b.y()),
                                           longitude(b.x()), expected);
  EXPECT_GT(expected, 14000);
  const Vec2 first = city->buildings[0].footprint[0].outer[0];
  const Vec2 second = city->buildings[1].footprint[0].outer[0];
  EXPECT_NEAR((second - first).norm(), expected, 1e-5 * expected);
}

TEST(ReadCity, TakesALayerWithoutASystemBesideMercator) {
  const fs::path path = fs::path(::testing::TempDir()) / "layer.city.json";
  std::ofstream(path)
      << R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[1491100,6894000,0]},
      "CityObjects":{"b":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]}]}},
      "vertices":[[0,0,0],[9,0,0],[0,9,0]]})";
  const Result<CityModel> city =
      readCity({houseAt(1491000, 6894000, "with.geojson", "urn:ogc:def:crs:EPSG::3857"), path});
  ASSERT_TRUE(city.ok());
  EXPECT_EQ(city->buildings.size(), 2U);
  EXPECT_THAT(codes(city.diagnostics), Contains(Code::CrsAssumed));
  EXPECT_THAT(codes(city.diagnostics), testing::Not(Contains(Code::InputLeftOut)));
}

TEST(ReadCity, SaysWhenTheDataAreNoPlaceForTheirSystem) {
  const Result<CityModel> result =
      readCity({houseAt(100, 200, "astray.geojson", "urn:ogc:def:crs:EPSG::25832")});
  ASSERT_TRUE(result.ok());
  EXPECT_THAT(codes(result.diagnostics), Contains(Code::OutsideAreaOfUse));
  EXPECT_THAT(codes(readCity({kData / "town_utm.geojson"}).diagnostics),
              testing::Not(Contains(Code::OutsideAreaOfUse)));
  EXPECT_THAT(codes(readCity({kData / "town_degrees.geojson"}).diagnostics),
              testing::Not(Contains(Code::OutsideAreaOfUse)));
}

TEST(ReadCity, SaysWhichInputWasTakenToBeInTheOthersSystem) {
  const fs::path path = fs::path(::testing::TempDir()) / "nowhere.city.json";
  std::ofstream(path)
      << R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},
      "CityObjects":{"b":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]}]}},
      "vertices":[[0,0,0],[9,0,0],[0,9,0]]})";
  const auto said = codes(readCity({kData / "town_utm.geojson", path}).diagnostics);
  EXPECT_THAT(said, Contains(Code::CrsAssumed));
  EXPECT_THAT(said, testing::Not(Contains(Code::CrsMissing)));
  EXPECT_THAT(codes(readCity({path}).diagnostics), testing::Not(Contains(Code::CrsAssumed)));
}

TEST(ReadLines, SaysWhenNoneIsNearTheBuildings) {
  const Result<CityModel> model = readCity({kData / "town_utm.geojson"});
  ASSERT_TRUE(model.ok());
  const Result<LineLayer> near = readLines(kData / "streets_degrees.geojson", *model);
  EXPECT_THAT(codes(near.diagnostics), testing::Not(Contains(Code::BarriersFarAway)));
  const Result<LineLayer> far =
      readLines(houseAt(300000, 5000000, "far.geojson", "urn:ogc:def:crs:EPSG::25832"), *model);
  ASSERT_TRUE(far.ok());
  EXPECT_THAT(codes(far.diagnostics), Contains(Code::BarriersFarAway));
}

TEST(ReadCity, TwoFilesBecomeOneModelInTheOrderGiven) {
  // The second holds the same three houses in degrees.
  const std::vector<fs::path> paths{kData / "town_utm.geojson", kData / "town_degrees.geojson"};
  const Result<CityModel> result = readCity(paths);
  ASSERT_TRUE(result.ok());
  ASSERT_EQ(result->buildings.size(), 6U);
  ASSERT_EQ(result->sources.size(), 2U);
  EXPECT_EQ(result->crs.epsg, 25832);
  EXPECT_THAT(codes(result.diagnostics), Contains(Code::CrsMixed));
  EXPECT_THAT(codes(result.diagnostics), Contains(Code::DuplicateId));
  for (std::size_t i = 0; i < 3; ++i) {
    const Building& first = result->buildings[i];
    const Building& second = result->buildings[i + 3];
    EXPECT_EQ(first.source, 0U);
    EXPECT_EQ(second.source, 1U);
    EXPECT_EQ(second.object.id, first.object.id + "_2");
    ASSERT_EQ(first.footprint.size(), second.footprint.size());
    for (std::size_t k = 0; k < first.footprint[0].outer.size(); ++k) {
      EXPECT_LT((first.footprint[0].outer[k] - second.footprint[0].outer[k]).norm(), 0.02);
    }
  }
}

TEST(ReadCity, TakesTheSystemThatIsTold) {
  ImportOptions options;
  options.crs = "EPSG:25833";
  const Result<CityModel> result = readCity({kData / "town_utm.geojson"}, options);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->crs.epsg, 25833);
}

TEST(ReadCity, RefusesASystemThatIsNone) {
  for (const char* crs : {"EPSG:99999999", "nonsense", "EPSG:5783", "EPSG:25833+99999"}) {
    ImportOptions options;
    options.crs = crs;
    const Result<CityModel> result = readCity({kData / "town_utm.geojson"}, options);
    EXPECT_FALSE(result.ok()) << crs;
    EXPECT_EQ(codes(result.diagnostics), std::vector{Code::OptionBadValue}) << crs;
  }
  for (const char* crs : {"", "25833", "EPSG:25833+7837", "urn:ogc:def:crs:EPSG::25833", "EPSG:4326",
                          "EPSG:4978", "ETRS89 / UTM zone 33N", "+proj=utm +zone=33 +ellps=GRS80"})
    EXPECT_FALSE(whyNoSystem(crs)) << crs;
}

// Coordinates of one city in the system of another, and a file in metres of its own beside one with a system.
TEST(ReadCity, SaysWhenInputsLieFarApart) {
  const std::string utm = "urn:ogc:def:crs:EPSG::25832";
  const fs::path first = houseAt(600000, 5700000, "here.geojson", utm);
  const fs::path near = houseAt(615000, 5700000, "near.geojson", utm);
  const fs::path far = houseAt(900000, 5700000, "there.geojson", utm);
  EXPECT_THAT(codes(readCity({first, near}).diagnostics), testing::Not(Contains(Code::InputsFarApart)));
  // There is no gap of 20 km on the way from the first to the last.
  const fs::path next = houseAt(630000, 5700000, "next.geojson", utm);
  EXPECT_THAT(codes(readCity({first, next, near}).diagnostics), testing::Not(Contains(Code::InputsFarApart)));
  const Result<CityModel> apart = readCity({far, first, near});
  const auto said = std::find_if(apart.diagnostics.begin(), apart.diagnostics.end(),
                                 [](const Diagnostic& d) { return d.code == Code::InputsFarApart; });
  ASSERT_NE(said, apart.diagnostics.end());
  EXPECT_THAT(said->text, testing::HasSubstr("there.geojson is 285 km from here.geojson, near.geojson"));
}

TEST(ReadCity, SaysHowFarABrokenInputWasRead) {
  const auto write = [](const std::string& name, const std::string& text) {
    const fs::path path = fs::path(::testing::TempDir()) / name;
    std::ofstream(path) << text;
    return path;
  };
  const std::string head =
      R"(<CityModel xmlns="http://www.opengis.net/citygml/2.0" xmlns:b="http://www.opengis.net/citygml/building/2.0")"
      R"( xmlns:gml="http://www.opengis.net/gml">)";
  const std::string building = R"(<cityObjectMember><b:Building gml:id="whole"/></cityObjectMember>)";
  const std::string half = R"(<cityObjectMember><b:Building gml:id="half"><b:measuredHeight>9)";
  const Result<CityModel> part = readCity({write("part.gml", head + building + half)});
  ASSERT_TRUE(part.ok());
  EXPECT_EQ(part->buildings.size(), 1U);
  EXPECT_THAT(codes(part.diagnostics), Contains(Code::FileTruncated));
  EXPECT_THAT(codes(part.diagnostics), Contains(Code::InputReadInPart));

  const Result<CityModel> nothing = readCity({write("nothing.gml", head + half)});
  EXPECT_FALSE(nothing.ok());
  EXPECT_EQ(codes(nothing.diagnostics), std::vector{Code::FileTruncated});
  EXPECT_THAT(format(nothing.diagnostics.at(0)), testing::Not(testing::HasSubstr("was read")));
}

TEST(ReadCity, Stops) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)readCity({kData / "town_utm.geojson", kData / "town_degrees.geojson"}, {},
                              Progress({}, stop.get_token())),
               Cancelled);
}

TEST(ReadLines, LandInTheFrameOfTheModel) {
  const Result<CityModel> model = readCity({kData / "town_utm.geojson"});
  ASSERT_TRUE(model.ok());
  const Result<LineLayer> lines = readLines(kData / "streets_degrees.geojson", *model);
  ASSERT_TRUE(lines.ok());
  ASSERT_EQ(lines->lines.size(), 3U);  // a line, and a multi-line of two
  EXPECT_EQ(lines->kinds[0], "residential");
  // The first street starts at the corner of the first house.
  EXPECT_LT((lines->lines[0][0] - model->buildings[0].footprint[0].outer[0]).norm(), 0.02);
}

TEST(ReadLines, SayWhichLayerThereIsNot) {
  const auto model = readCity({kData / "town_utm.geojson"});
  ASSERT_TRUE(model.ok());
  const fs::path osm = fs::path(::testing::TempDir()) / "streets.osm";
  std::ofstream(osm) << R"(<osm version="0.6"><node id="1" lat="49" lon="8"/><node id="2" lat="49.1" lon="8"/>
<way id="3"><nd ref="1"/><nd ref="2"/><tag k="highway" v="service"/></way></osm>)";
  EXPECT_EQ(readLines(osm, *model)->lines.size(), 1U);
  EXPECT_EQ(readLines(osm, *model, "lines")->lines.size(), 1U);
  EXPECT_THAT(codes(readLines(osm, *model, "nope").diagnostics), testing::ElementsAre(Code::LayerMissing));
  const auto one = readLines(kData / "streets_degrees.geojson", *model, "nope");
  EXPECT_TRUE(one.ok());
  EXPECT_THAT(codes(one.diagnostics), Contains(Code::OptionUnused));
}

TEST(ReadLines, SayWhenThereAreNone) {
  const Result<CityModel> model = readCity({kData / "town_utm.geojson"});
  const fs::path noise = fs::path(::testing::TempDir()) / "noise.geojson";
  std::ofstream(noise) << "{\"type\": \"FeatureCollection\", \"features\": []}";
  EXPECT_THAT(codes(readLines(noise, *model).diagnostics), Contains(Code::BarrierFileBad));
  EXPECT_THAT(codes(readLines(kData / "absent.geojson", *model).diagnostics), Contains(Code::FileNotFound));
}

struct Known {
  const char* path;
  std::size_t buildings;
  std::size_t repeated = 1;
};

class RealFootprints : public ::testing::TestWithParam<Known> {};

// Counts of shared/data/README.md, less what a diagnostic accounts for: 201 and 217 of parts of an extract
// whose nodes were cut away.
TEST_P(RealFootprints, HaveTheCountsOfTheirReadme) {
  const fs::path path = test::sharedData(std::string("C_footprints/") + GetParam().path);
  if (path.empty()) GTEST_SKIP() << "shared data not present";
  const Result<CityModel> result = readCity({path});
  ASSERT_TRUE(result.ok());
  std::size_t leftOut = 0;
  for (const Diagnostic& diagnostic : result.diagnostics)
    leftOut += diagnostic.code == Code::FootprintInvalid ? 1 : 0;
  EXPECT_EQ(result->buildings.size() + leftOut, GetParam().buildings);
  for (const Building& building : result->buildings) {
    ASSERT_FALSE(building.footprint.empty());
    EXPECT_GT(building.height, 0);
    for (const Polygon& polygon : building.footprint) {
      EXPECT_GT(signedArea(polygon.outer), 0);
      for (const Ring& hole : polygon.holes) EXPECT_LT(signedArea(hole), 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, RealFootprints,
                         ::testing::Values(Known{"geoclimate_heights_roads/BUILDING.geojson", 2506},
                                           Known{"hancock_ms_41k_shp/tiled_footprints.zip", 41023},
                                           Known{"hancock_ms_41k_shp/BuildingFootprintsOSM.gpkg", 10724},
                                           Known{"mago_samples/sample-geojson/footprint-with-height.geojson",
                                                 177},
                                           Known{"mago_samples/sample-geopackage/footprint.gpkg", 177},
                                           Known{"mago_samples/sample-shape/footprint.shp", 177},
                                           Known{"manhattan_trips_deckgl/trips/buildings.json", 999},
                                           Known{"suzhou_pybdshadow/bd_demo.json", 1374},
                                           Known{"prague_bubenec_momepy/bubenec.gpkg", 144},
                                           Known{"osm_with_streets/monaco-latest.osm.pbf", 1183 + 24},
                                           Known{"plateau_osm_heights/53395403_bldg_6697_op.osm", 1167},
                                           Known{"plateau_osm_heights/54392491_bldg_6697_op.osm", 2145}));

TEST(LongRealFootprints, AlleghenyAsOneLayerOfManyFiles) {
  const fs::path folder = test::sharedData("C_footprints/allegheny_547k_osm");
  if (folder.empty()) GTEST_SKIP() << "shared data not present";
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  const Result<CityModel> result = readCity(paths);
  ASSERT_TRUE(result.ok());
  const std::vector<Code> said = codes(result.diagnostics);
  // All corners of way/-7516030 are one place: no outline, left out and said.
  EXPECT_EQ(result->buildings.size() +
                static_cast<std::size_t>(std::count(said.begin(), said.end(), Code::FootprintInvalid)),
            122649U);
  EXPECT_EQ(result->sources.size(), paths.size());
}

TEST(RealLines, GeoclimatesRoads) {
  const fs::path buildings = test::sharedData("C_footprints/geoclimate_heights_roads/BUILDING.geojson");
  if (buildings.empty()) GTEST_SKIP() << "shared data not present";
  const Result<CityModel> model = readCity({buildings});
  ASSERT_TRUE(model.ok());
  const Result<LineLayer> roads = readLines(buildings.parent_path() / "ROAD.geojson", *model);
  ASSERT_TRUE(roads.ok());
  EXPECT_EQ(roads->lines.size(), 873U);
  // Streets run among the buildings.
  Box3 box = bounds(*model);
  std::size_t inside = 0;
  for (const auto& line : roads->lines)
    inside += box.contains({line[0].x(), line[0].y(), box.min.z()}) ? 1 : 0;
  EXPECT_GT(inside, roads->lines.size() / 2);
}

}  // namespace
}  // namespace lodestone
