// Coordinates, rings and surfaces in every way they can be written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/citygml_text.h"

namespace lodestone::test {
namespace {

using testing::ElementsAre;

TEST(CityGml, EveryWayToWriteCoordinatesGivesTheSameRing) {
  const std::string inside[] = {
      "<g:posList>0 0 5 1 0 5 1 1 5 0 0 5</g:posList>",
      "<g:posList srsDimension='3'>\n 0 0 5\t1 0 5 1e0 +1.0 5\n0 0 5 </g:posList>",
      "<g:pos>0 0 5</g:pos><g:pos>1 0 5</g:pos><g:pos>1 1 5</g:pos><g:pos>0 0 5</g:pos>",
      "<g:coordinates>0,0,5 1,0,5 1,1,5 0,0,5</g:coordinates>",
      "<g:pointProperty><g:Point><g:pos>0 0 5</g:pos></g:Point></g:pointProperty><g:pos>1 0 "
      "5</g:pos><g:pos>1 1 5</g:pos><g:pos>0 0 5</g:pos>",
  };
  for (const std::string& text : inside) {
    const auto model = read2(building(multi("1", member("<g:Polygon><g:exterior><g:LinearRing>" + text +
                                                        "</g:LinearRing></g:exterior></g:Polygon>"))));
    ASSERT_TRUE(model);
    EXPECT_TRUE(model.diagnostics.empty()) << text;
    EXPECT_EQ(ringOf(only(model).geometries.at(0), 0), (std::vector<Vec3>{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}}))
        << text;
  }
}

TEST(CityGml, TwoDimensionsByAttributeOrByCount) {
  for (const std::string& text : {"<g:Polygon srsDimension='2'><g:exterior>" +
                                      ring("0 0 1 0 1 1 0 1 0 0 0 0") + "</g:exterior></g:Polygon>",
                                  polygon("", "0 0 1 0 1 1 0 0")}) {
    const auto model = read2(
        building("<b:lod0FootPrint><g:MultiSurface>" + member(text) + "</g:MultiSurface></b:lod0FootPrint>"));
    ASSERT_TRUE(model);
    EXPECT_TRUE(model.diagnostics.empty());
    const Geometry& g = only(model).geometries.at(0);
    EXPECT_EQ(g.lod, "0");
    EXPECT_EQ(g.surfaces.at(0).type, SurfaceType::Ground);
    EXPECT_EQ(g.vertices.at(1), Vec3(1, 0, 0));
  }
}

TEST(CityGml, HolesStayAndBrokenRingsAreSaid) {
  const auto with = [](const std::string& outer, const std::string& inner) {
    return read2(
        building(multi("1", member("<g:Polygon><g:exterior>" + ring(outer) + "</g:exterior><g:interior>" +
                                   ring(inner) + "</g:interior></g:Polygon>") +
                                member(polygon()))));
  };
  const auto good = with("0 0 0 9 0 0 9 9 0 0 0 0", "1 1 0 2 2 0 2 1 0 1 1 0");
  ASSERT_TRUE(good);
  EXPECT_TRUE(good.diagnostics.empty());
  EXPECT_THAT(only(good).geometries.at(0).surfaceStart, ElementsAre(0U, 2U, 3U));

  const auto flatHole = with("0 0 0 9 0 0 9 9 0 0 0 0", "1 1 0 1 1 0 1 1 0");
  EXPECT_THAT(codesOf(flatHole.diagnostics), ElementsAre(Code::HoleDropped));
  EXPECT_THAT(only(flatHole).geometries.at(0).surfaceStart, ElementsAre(0U, 1U, 2U));

  const std::pair<const char*, Code> broken[] = {
      {"0 0 0 1 0 0 0 0 0", Code::RingTooShort},         {"", Code::RingTooShort},
      {"0 0 0 nan 0 0 1 1 0", Code::CoordinateBad},      {"0 0 0 inf 0 0 1 1 0", Code::CoordinateBad},
      {"0 0 0 1e999 0 0 1 1 0", Code::CoordinateBad},    {"0 0 0 x 0 0 1 1 0", Code::CoordinateBad},
      {"0 0 0 1 0 0 1 1 0 0 0 0 7", Code::CoordinateBad}};
  for (const auto& [outer, code] : broken) {
    const auto model = with(outer, "1 1 0 2 2 0 2 1 0 1 1 0");
    ASSERT_TRUE(model) << outer;
    EXPECT_THAT(codesOf(model.diagnostics), ElementsAre(code)) << outer;
    EXPECT_NE(model.diagnostics[0].place.find(":1"), std::string::npos);
    EXPECT_EQ(only(model).geometries.at(0).surfaceCount(), 1U) << outer;
  }
}

TEST(CityGml, TrianglesPatchesTinsAndCompositeSolids) {
  const std::string triangle =
      "<g:Triangle><g:exterior>" + ring("0 0 0 1 0 0 1 1 0 0 0 0") + "</g:exterior></g:Triangle>";
  const auto model = read2(building(
      "<b:lod1MultiSurface><g:TriangulatedSurface><g:trianglePatches>" + triangle + triangle +
      "</g:trianglePatches></g:TriangulatedSurface></b:lod1MultiSurface>"
      "<b:lod2Solid><g:CompositeSolid><g:solidMember><g:Solid><g:exterior><g:Shell>" +
      member(polygon("shared")) + member(polygon()) + "</g:Shell></g:exterior><g:interior><g:Shell>" +
      member(polygon()) +
      "</g:Shell></g:interior></g:Solid></g:solidMember>"
      "<g:solidMember><g:Solid><g:exterior><g:CompositeSurface>" +
      link("shared") +
      "</g:CompositeSurface></g:exterior></g:Solid></g:solidMember></g:CompositeSolid></b:lod2Solid>"));
  ASSERT_TRUE(model);
  ASSERT_EQ(only(model).geometries.size(), 2U);
  const auto& solids = only(model).geometries[0];
  EXPECT_EQ(solids.kind, GeometryKind::CompositeSolid);
  EXPECT_THAT(solids.shellStart, ElementsAre(0U, 2U, 3U, 4U));
  EXPECT_THAT(solids.solidStart, ElementsAre(0U, 2U, 3U));
  EXPECT_EQ(only(model).geometries[1].surfaceCount(), 2U);
}

TEST(CityGml, SrsNameOfTheEnvelopeElseOfTheFirstGeometry) {
  const auto enveloped =
      read2("<g:boundedBy><g:Envelope srsName='urn:ogc:def:crs:EPSG::25833'/></g:boundedBy>" + building(""));
  EXPECT_EQ(enveloped->crs.source, "urn:ogc:def:crs:EPSG::25833");
  const auto geometry = read2(building("<b:lod1MultiSurface><g:MultiSurface srsName='EPSG:7415'>" +
                                       member(polygon()) + "</g:MultiSurface></b:lod1MultiSurface>"));
  EXPECT_EQ(geometry->crs.source, "EPSG:7415");
  EXPECT_EQ(read2(building(""))->crs.source, "");
}

}  // namespace
}  // namespace lodestone::test
