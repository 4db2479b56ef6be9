#include "model/io/places/georeference.h"

#include <memory>
#include <random>

#include <GeographicLib/Geodesic.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include "model/io/places/crs_spelling.h"

namespace lodestone {
namespace {

using ::testing::Contains;
using ::testing::Field;

struct Spelled {
  const char* spelling;
  int epsg;
  int verticalEpsg;
  CrsKind kind;
};

class Spelling : public ::testing::TestWithParam<Spelled> {};

TEST_P(Spelling, Resolves) {
  const Crs crs = resolveCrs(GetParam().spelling);
  EXPECT_EQ(crs.epsg, GetParam().epsg);
  EXPECT_EQ(crs.verticalEpsg, GetParam().verticalEpsg);
  EXPECT_EQ(crs.kind, GetParam().kind);
  EXPECT_EQ(crs.source, GetParam().spelling);
  if (crs.kind == CrsKind::Projected) {
    EXPECT_FALSE(crs.name.empty());
  }
}

constexpr const char* kWkt =
    R"(PROJCS["RGF93 / Lambert-93",GEOGCS["RGF93",DATUM["Reseau_Geodesique_Francais_1993",SPHEROID["GRS 1980",6378137,298.257222101]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Lambert_Conformal_Conic_2SP"],PARAMETER["standard_parallel_1",49],PARAMETER["standard_parallel_2",44],PARAMETER["latitude_of_origin",46.5],PARAMETER["central_meridian",3],PARAMETER["false_easting",700000],PARAMETER["false_northing",6600000],UNIT["metre",1],AUTHORITY["EPSG","2154"]])";
constexpr CrsKind kProjected = CrsKind::Projected;
constexpr CrsKind kGeographic = CrsKind::Geographic;

INSTANTIATE_TEST_SUITE_P(
    All, Spelling,
    ::testing::Values(
        Spelled{"EPSG:25832", 25832, 0, kProjected}, Spelled{" epsg:25832\n", 25832, 0, kProjected},
        Spelled{"25832", 25832, 0, kProjected}, Spelled{"urn:ogc:def:crs:EPSG::25833", 25833, 0, kProjected},
        Spelled{"urn:ogc:def:crs:EPSG:6.12:3068", 3068, 0, kProjected},
        Spelled{"urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::5783", 25832, 5783, kProjected},
        Spelled{"urn:ogc:def:crs,crs:EPSG:6.12:31466,crs:EPSG:6.12:5783", 31466, 5783, kProjected},
        Spelled{"urn:ogc:def:crs:EPSG:25832, crs:EPSG:5783", 25832, 5783, kProjected},
        Spelled{"EPSG:25832+5783", 25832, 5783, kProjected},
        Spelled{"EPSG:25832+EPSG:5783", 25832, 5783, kProjected},
        Spelled{"http://www.opengis.net/def/crs/EPSG/0/28992", 28992, 0, kProjected},
        Spelled{"https://www.opengis.net/def/crs/EPSG/0/7415", 7415, 0, kProjected},
        Spelled{"http://www.opengis.net/def/crs/EPSG/6.12/3068", 3068, 0, kProjected},
        Spelled{"http://www.opengis.net/def/crs-compound?1=http://www.opengis.net/def/crs/EPSG/0/"
                "25832&2=http://www.opengis.net/def/crs/EPSG/0/5783",
                25832, 5783, kProjected},
        Spelled{"http://www.opengis.net/gml/srs/epsg.xml#28992", 28992, 0, kProjected},
        Spelled{"http://www.opengis.net/def/crs/EPSG/0/6697", 6697, 0, kGeographic},
        Spelled{"EPSG:4979", 4979, 0, kGeographic},
        Spelled{"urn:ogc:def:crs:OGC:1.3:CRS84", 4326, 0, kGeographic},
        Spelled{"OGC:CRS84", 4326, 0, kGeographic},
        Spelled{"urn:adv:crs:ETRS89_UTM32*DE_DHHN92_NH", 25832, 5783, kProjected},
        Spelled{"urn:adv:crs:ETRS89_UTM33*DE_DHHN2016_NH*GCG2016", 25833, 7837, kProjected},
        Spelled{"urn:adv:crs:DE_DHDN_3GK4*DE_DHHN92_NH", 31468, 5783, kProjected},
        Spelled{"urn:adv:crs:DE_DHDN_3GK2", 31466, 0, kProjected}, Spelled{"CH1903", 21781, 0, kProjected},
        Spelled{"CH1903+", 2056, 0, kProjected}, Spelled{"WGS84", 4326, 0, kGeographic},
        Spelled{"ETRS89 / UTM zone 32N", 25832, 0, kProjected}, Spelled{kWkt, 2154, 0, kProjected},
        Spelled{"+proj=utm +zone=32 +datum=WGS84 +units=m +no_defs", 32632, 0, kProjected},
        Spelled{"#local-CRS-1", 0, 0, CrsKind::Local}, Spelled{"", 0, 0, CrsKind::Unknown},
        Spelled{"EPSG:9999999", 0, 0, CrsKind::Unknown},
        Spelled{"http://www.opengis.net/def/crs/EPSG/0/9999999", 0, 0, CrsKind::Unknown},
        Spelled{"/etc/passwd", 0, 0, CrsKind::Unknown}, Spelled{"no such thing", 0, 0, CrsKind::Unknown}));

TEST(Georeference, KnowsUnits) {
  EXPECT_DOUBLE_EQ(resolveCrs("EPSG:2263").unit, 1200.0 / 3937.0);
  EXPECT_DOUBLE_EQ(resolveCrs("EPSG:2263").verticalUnit, 1200.0 / 3937.0);
  // NAVD88 height in metres (5703) beside feet.
  EXPECT_DOUBLE_EQ(resolveCrs("EPSG:2263+5703").verticalUnit, 1);
  EXPECT_DOUBLE_EQ(resolveCrs("EPSG:6697").unit, 1);
  EXPECT_DOUBLE_EQ(resolveCrs("EPSG:6697").verticalUnit, 1);
  EXPECT_NEAR(resolveCrs("EPSG:4807").unit, 0.9, 1e-12);  // NTF (Paris): grads
}

/// A building that is one square at a place, `size` units wide.
CityModel squareAt(const Vec3& corner, double size, const std::string& crs) {
  CityModel model;
  model.crs.source = crs;
  Building building;
  building.object.id = "b";
  building.object.type = ObjectType::Building;
  Geometry geometry;
  geometry.addRing(
      {corner, corner + Vec3(size, 0, 0), corner + Vec3(size, size, 0), corner + Vec3(0, size, 0)});
  geometry.finishSurface();
  building.object.geometries.push_back(std::move(geometry));
  model.buildings.push_back(std::move(building));
  return model;
}

std::vector<Vec3>& verticesOf(CityModel& model) {
  return model.buildings.at(0).object.geometries.at(0).vertices;
}

std::vector<Code> codes(const Diagnostics& diagnostics) {
  std::vector<Code> result;
  for (const Diagnostic& diagnostic : diagnostics) result.push_back(diagnostic.code);
  return result;
}

TEST(AxisOrder, GeographicFollowsTheAuthority) {
  CityModel plateau = squareAt({35.6, 139.7, 40}, 1e-4, "http://www.opengis.net/def/crs/EPSG/0/6697");
  EXPECT_TRUE(settleCrs(plateau, "", false).empty());
  EXPECT_EQ(verticesOf(plateau)[0], Vec3(139.7, 35.6, 40));
}

TEST(AxisOrder, ShortSpellingIsLongitudeFirst) {
  CityModel jefferson = squareAt({-77.0, 38.9, 0}, 1e-4, "EPSG:4979");
  EXPECT_TRUE(settleCrs(jefferson, "", false).empty());
  EXPECT_EQ(verticesOf(jefferson)[0], Vec3(-77.0, 38.9, 0));
}

TEST(AxisOrder, CoordinatesProveOtherwise) {
  // Longitude first though the spelling promises latitude first: 139.7 is no latitude.
  CityModel swapped = squareAt({139.7, 35.6, 40}, 1e-4, "urn:ogc:def:crs:EPSG::6697");
  (void)settleCrs(swapped, "", false);
  EXPECT_EQ(verticesOf(swapped)[0], Vec3(139.7, 35.6, 40));
  CityModel shortLatitudeFirst = squareAt({35.6, 139.7, 40}, 1e-4, "EPSG:6697");
  (void)settleCrs(shortLatitudeFirst, "", false);
  EXPECT_EQ(verticesOf(shortLatitudeFirst)[0], Vec3(139.7, 35.6, 40));
}

TEST(AxisOrder, GaussKruegerIsEastNorthUnlessProvenOtherwise) {
  const Vec3 place(4490655.5, 5322005.28, 548.47);  // Munich, as the OGC example writes it
  CityModel wild = squareAt(place, 10, "urn:adv:crs:DE_DHDN_3GK4*DE_DHHN92_NH");
  (void)settleCrs(wild, "", false);
  EXPECT_EQ(verticesOf(wild)[0], place);
  CityModel official =
      squareAt({place.y(), place.x(), place.z()}, 10, "urn:adv:crs:DE_DHDN_3GK4*DE_DHHN92_NH");
  (void)settleCrs(official, "", false);
  EXPECT_EQ(verticesOf(official)[0], place);
}

TEST(AxisOrder, VectorLayersAreNeverSwapped) {
  CityModel layer = squareAt({35.6, 139.7, 0}, 1e-4, "EPSG:6697");
  (void)settleCrs(layer, "", true);
  EXPECT_EQ(verticesOf(layer)[0], Vec3(35.6, 139.7, 0));
}

TEST(SettleCrs, EarthCentredBecomesGeographic) {
  // 8.43° E, 49.1° N, 120 m by GeographicLib's CartConvert.
  CityModel model = squareAt({4138350.91, 613284.65, 4797876.68}, 0.01, "EPSG:4978");
  EXPECT_THAT(codes(settleCrs(model, "", false)), Contains(Code::UnitsConverted));
  EXPECT_EQ(model.crs.epsg, 4979);
  const Vec3 p = verticesOf(model)[0];
  EXPECT_GT(p.x(), 8);
  EXPECT_LT(p.x(), 9);
  EXPECT_NEAR(p.y(), 49.1, 0.1);
}

TEST(SettleCrs, SaysWhatItTakes) {
  CityModel none = squareAt({400000, 5800000, 30}, 10, "");
  EXPECT_THAT(codes(settleCrs(none, "", false)), ::testing::ElementsAre(Code::CrsMissing));
  CityModel unknown = squareAt({400000, 5800000, 30}, 10, "EPSG:9999999");
  EXPECT_THAT(codes(settleCrs(unknown, "", false)), ::testing::ElementsAre(Code::CrsUnknown));
  CityModel degrees = squareAt({-89.3, 30.3, 0}, 1e-4, "");
  EXPECT_THAT(codes(settleCrs(degrees, "", true)), ::testing::ElementsAre(Code::CoordinatesLookGeographic));
  EXPECT_EQ(degrees.crs.epsg, 4326);
  CityModel house = squareAt({0, 0, 0}, 12, "");  // a house about 0 is not in the Gulf of Guinea
  EXPECT_THAT(codes(settleCrs(house, "", false)), ::testing::ElementsAre(Code::CrsMissing));
  CityModel told = squareAt({400000, 5800000, 30}, 10, "EPSG:9999999");
  EXPECT_TRUE(settleCrs(told, "EPSG:25833", false).empty());
  EXPECT_EQ(told.crs.epsg, 25833);
  CityModel local = squareAt({0, 0, 0}, 12, "#local-CRS-1");
  EXPECT_TRUE(settleCrs(local, "", false).empty());
  EXPECT_EQ(local.crs.kind, CrsKind::Local);
}

TEST(Localise, ProjectedSubtractsAWholeOrigin) {
  CityModel model = squareAt({458875.25, 5438355.5, 112}, 10, "EPSG:25832");
  (void)settleCrs(model, "", false);
  EXPECT_TRUE(localise(model).empty());
  EXPECT_EQ(model.origin, Vec3(458880, 5438360, 0));
  EXPECT_EQ(verticesOf(model)[0], Vec3(-4.75, -4.5, 112));
  EXPECT_EQ(toWorld(model, verticesOf(model)[0]), Vec3(458875.25, 5438355.5, 112));
}

TEST(Localise, FeetBecomeMetres) {
  CityModel model = squareAt({984250, 194305, 100}, 30, "EPSG:2263");
  model.buildings[0].base = 100;
  model.buildings[0].height = 50;
  model.buildings[0].heightSource = HeightSource::Geometry;
  (void)settleCrs(model, "", false);
  EXPECT_THAT(codes(localise(model)), ::testing::ElementsAre(Code::UnitsConverted));
  const Vec3 edge = verticesOf(model)[1] - verticesOf(model)[0];
  EXPECT_NEAR(edge.x(), 30 * 1200.0 / 3937, 1e-9);
  EXPECT_NEAR(model.buildings[0].base, 100 * 1200.0 / 3937, 1e-9);
  EXPECT_NEAR(model.buildings[0].height, 50 * 1200.0 / 3937, 1e-9);
  EXPECT_NEAR(toWorld(model, verticesOf(model)[0]).x(), 984250, 1e-6);
  EXPECT_NEAR(toWorld(model, verticesOf(model)[0]).z(), 100, 1e-9);
}

TEST(Localise, AttributeHeightsAreMetresWhateverTheGroundIsMeasuredIn) {
  CityModel model = squareAt({984250, 194305, 0}, 30, "EPSG:2263");
  model.buildings[0].height = 50;
  model.buildings[0].heightSource = HeightSource::Attribute;
  (void)settleCrs(model, "", false);
  (void)localise(model);
  EXPECT_EQ(model.buildings[0].height, 50);
}

TEST(Localise, LeavesOutWhatIsNoPlace) {
  CityModel model = squareAt({8.43, 49.1, 0}, 1e-4, "EPSG:4326");
  Building broken = model.buildings[0];
  broken.object.id = "broken";
  broken.object.geometries[0].vertices[2].y() = std::numeric_limits<double>::quiet_NaN();
  model.buildings.push_back(broken);
  (void)settleCrs(model, "", true);
  const Diagnostics diagnostics = localise(model);
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics[0].code, Code::CoordinateBad);
  EXPECT_EQ(diagnostics[0].object, "broken");
  ASSERT_EQ(model.buildings.size(), 1U);
  EXPECT_EQ(model.buildings[0].object.id, "b");
}

TEST(Localise, DistancesAreThoseOfTheEarth) {
  const GeographicLib::Geodesic& earth = GeographicLib::Geodesic::WGS84();
  CityModel model = squareAt({8.43, 49.1, 0}, 1e-4, "EPSG:4326");
  (void)settleCrs(model, "", true);
  (void)localise(model);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> nearby(-0.1, 0.1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 a(8.43 + nearby(random), 49.1 + nearby(random), 0);
    const Vec3 b = a + Vec3(nearby(random) / 100, nearby(random) / 100, 0);
    double expected = 0;
    earth.Inverse(a.y(), a.x(), b.y(), b.x(), expected);
    const double offAxis = std::abs(toLocal(model, a).x()) + 100;
    const double scale = offAxis * offAxis / (2 * 6.371e6 * 6.371e6);
    EXPECT_NEAR((toLocal(model, a) - toLocal(model, b)).norm(), expected,
                expected * (1.02 * scale + 1e-9) + 1e-6);
  }
}

class FrameRoundTrip : public ::testing::TestWithParam<const char*> {};

TEST_P(FrameRoundTrip, IsExact) {
  CityModel model;
  model.crs = resolveCrs(GetParam());
  model.origin = model.crs.kind == kGeographic ? Vec3(13.4, 52.5, 0) : Vec3(390000, 5820000, 0);
  EXPECT_LT((toWorld(model, Vec3(0, 0, 0)) * model.crs.unit - model.origin).norm(), 1e-6);
  std::mt19937 random(1);
  for (const double reach : {10.0, 1000.0, 50000.0, 200000.0}) {
    std::uniform_real_distribution<double> along(-reach, reach);
    for (int i = 0; i < 100; ++i) {
      const Vec3 local(along(random), along(random), along(random) / 100);
      EXPECT_LT((toLocal(model, toWorld(model, local)) - local).norm(), 1e-6);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, FrameRoundTrip,
                         ::testing::Values("EPSG:4326", "EPSG:6697", "EPSG:4314", "EPSG:4807", "EPSG:25833",
                                           "EPSG:2263", "EPSG:3857", "EPSG:3395", "EPSG:5641", "#local", ""));

// One place in a Mercator projection, and in the degrees of its own datum by PROJ: the same metres.
class MercatorFrame : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(MercatorFrame, EqualsTheFrameOfItsDegrees) {
  const Crs mercator = resolveCrs(GetParam().first);
  const Crs degrees = resolveCrs(GetParam().second);
  ASSERT_TRUE(projectsAboutOrigin(mercator));
  const auto from = horizontalReference(degrees);
  const auto to = horizontalReference(mercator);
  const std::unique_ptr<OGRCoordinateTransformation> proj(
      OGRCreateCoordinateTransformation(from.get(), to.get()));
  ASSERT_TRUE(proj);
  for (const double latitude : {-41.3, 0.0, 1.3, 35.7, 52.5}) {
    const Vec2 centre(100.4, latitude);
    const auto project = [&](Vec2 p) {
      EXPECT_TRUE(proj->Transform(1, &p.x(), &p.y()));
      return p;
    };
    const Vec2 origin = project(centre) * mercator.unit;
    const Frame projected(mercator, {origin.x(), origin.y(), 0});
    const Frame geographic(degrees, {centre.x(), centre.y(), 0});
    for (const Vec2& step : {Vec2(0, 0), Vec2(0.05, 0.02), Vec2(-0.07, 0.06), Vec2(0.01, -0.08)}) {
      const Vec2 place = centre + step;
      EXPECT_LT((projected.toLocal(project(place)) - geographic.toLocal(place)).norm(), 1e-5);
      EXPECT_LT((projected.toWorld(geographic.toLocal(place)) - project(place)).norm(), 1e-5);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Systems, MercatorFrame,
    ::testing::Values(std::pair("EPSG:3857", "EPSG:4326"), std::pair("ESRI:102100", "EPSG:4326"),
                      std::pair("EPSG:3395", "EPSG:4326"), std::pair("EPSG:3832", "EPSG:4326"),
                      std::pair("EPSG:3994", "EPSG:4326"), std::pair("EPSG:5641", "EPSG:4674"),
                      std::pair("EPSG:3001", "EPSG:4211")));

TEST(MercatorFrame, GoesOnBeyondTheDateLine) {
  const Frame frame(resolveCrs("EPSG:3857"), {20037500, 0, 0});
  const Vec2 local = frame.toLocal(Vec2(20038500, 1000));
  EXPECT_NEAR(local.x(), 1000, 0.1);
  EXPECT_LT((frame.toWorld(local) - Vec2(20038500, 1000)).norm(), 1e-6);
}

TEST(MercatorFrame, IsNotOfOtherProjections) {
  for (const char* other : {"EPSG:25833", "EPSG:2263", "EPSG:3068", "EPSG:2056", "EPSG:28992", "#local", ""})
    EXPECT_FALSE(projectsAboutOrigin(resolveCrs(other))) << other;
}

TEST(FrameRoundTripMany, EqualsOneByOne) {
  CityModel model;
  model.crs = resolveCrs("EPSG:4326");
  model.origin = Vec3(13.4, 52.5, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 5000; ++i) points.emplace_back(i, -2 * i, i % 100);
  std::vector<Vec3> world = points;
  toWorld(model, world);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(world[i], toWorld(model, points[i]));
  toLocal(model, world);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT((world[i] - points[i]).norm(), 1e-6);
}

// Places by `gdaltransform -s_srs <geographic> -t_srs <projected>`: the frames of a geographic system and of
// the projected one over the same datum must give the same distances, up to the projections' own scale.
TEST(Reproject, GoesWherePublishedCoordinatesAre) {
  struct Known {
    const char* from;
    Vec2 degrees;
    const char* to;
    Vec2 metres;
  };
  const Known known[] = {
      {"EPSG:4326", {8.43, 49.1}, "EPSG:25832", {458392.386384975, 5438728.84025285}},
      {"EPSG:4314", {11.87, 48.03}, "EPSG:31468", {4490305.50920325, 5321228.75247962}},
      {"EPSG:4149", {7.44, 46.95}, "CH1903", {600031.715701154, 199732.604674102}},
      {"EPSG:4314", {13.4, 52.5}, "EPSG:3068", {24572.4587328987, 19075.7277694225}},
      {"EPSG:4289",
       {5.39, 52.16},
       "http://www.opengis.net/def/crs/EPSG/0/28992",
       {155161.543040738, 463427.130652219}},
  };
  for (const Known& k : known) {
    CityModel model = squareAt({k.degrees.x(), k.degrees.y(), 7}, 1e-4, k.from);
    (void)settleCrs(model, "", true);
    EXPECT_THAT(codes(reproject(model, resolveCrs(k.to))), ::testing::ElementsAre(Code::CrsMixed));
    EXPECT_NEAR((verticesOf(model)[0].head<2>() - k.metres).norm(), 0, 1e-3) << k.to;
    EXPECT_EQ(verticesOf(model)[0].z(), 7);
    EXPECT_EQ(model.crs.source, k.to);
  }
}

TEST(Reproject, SaysWhatCannotBeTransformed) {
  CityModel model = squareAt({8.43, 49.1, 0}, 1e-4, "EPSG:4326");
  verticesOf(model)[0] = Vec3(8.43, 4900, 0);
  model.crs = resolveCrs("EPSG:4326");
  EXPECT_THAT(codes(reproject(model, resolveCrs("EPSG:25832"))),
              ::testing::ElementsAre(Code::CrsMixed, Code::CrsTransformFailed));
  EXPECT_TRUE(model.buildings.empty());
}

TEST(Reproject, LeavesTheSameSystemAlone) {
  CityModel model = squareAt({458875, 5438355, 0}, 10, "EPSG:25832");
  model.crs = resolveCrs("urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::5783");
  EXPECT_TRUE(reproject(model, resolveCrs("EPSG:25832")).empty());
  EXPECT_EQ(verticesOf(model)[0], Vec3(458875, 5438355, 0));
}

// Any GIS puts the local metres back by the PROJ string that exports carry.
TEST(Frame, OfDegreesAndMercatorIsAProjection) {
  struct Place {
    const char* crs;
    Vec3 origin;
  };
  for (const auto& [spelling, origin] :
       {Place{"EPSG:4326", {13.4, 52.5, 0}}, Place{"EPSG:3857", {1491000, 6894000, 0}}}) {
    const Crs crs = resolveCrs(spelling);
    const Vec2 local(1234.5, -678.25);
    const Vec2 world = Frame(crs, origin).toWorld(local);
    const Crs projected = resolveCrs(localProjection(crs, origin));
    ASSERT_EQ(projected.kind, CrsKind::Projected) << localProjection(crs, origin);
    const auto from = horizontalReference(projected);
    const auto to = horizontalReference(crs);
    const std::unique_ptr<OGRCoordinateTransformation> back(
        OGRCreateCoordinateTransformation(from.get(), to.get()));
    ASSERT_TRUE(back);
    Vec2 p = local;
    ASSERT_TRUE(back->Transform(1, &p.x(), &p.y()));
    const double tolerance = crs.kind == CrsKind::Geographic ? 1e-9 : 1e-4;
    EXPECT_LT((p - world).norm(), tolerance) << spelling;
  }
  EXPECT_TRUE(localProjection(resolveCrs("EPSG:25833"), {1, 2, 3}).empty());
}

}  // namespace
}  // namespace lodestone
