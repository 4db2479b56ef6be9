// What CityGML says in every way it can be said, on inputs small enough to see the answer.
#include <algorithm>
#include <cmath>
#include <string>

#include <cpl_vsi.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/io/citygml.h"

namespace lodestone {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

constexpr const char* kHead2 =
    "<c:CityModel xmlns:c='http://www.opengis.net/citygml/2.0' "
    "xmlns:b='http://www.opengis.net/citygml/building/2.0' "
    "xmlns:g='http://www.opengis.net/gml' xmlns:x='http://www.w3.org/1999/xlink' "
    "xmlns:gen='http://www.opengis.net/citygml/generics/2.0' "
    "xmlns:a='http://www.opengis.net/citygml/appearance/2.0' "
    "xmlns:f='http://www.opengis.net/citygml/cityfurniture/2.0' "
    "xmlns:grp='http://www.opengis.net/citygml/cityobjectgroup/2.0' "
    "xmlns:ade='http://example.org/ade'>";
constexpr const char* kHead3 =
    "<CityModel xmlns='http://www.opengis.net/citygml/3.0' "
    "xmlns:b='http://www.opengis.net/citygml/building/3.0' "
    "xmlns:con='http://www.opengis.net/citygml/construction/3.0' xmlns:g='http://www.opengis.net/gml/3.2' "
    "xmlns:gen='http://www.opengis.net/citygml/generics/3.0' "
    "xmlns:a='http://www.opengis.net/citygml/appearance/3.0' "
    "xmlns:x='http://www.w3.org/1999/xlink'>";

/// Reads text as a file of GDAL's memory.
Result<CityModel> readText(const std::string& text, const ImportOptions& options = {}) {
  const char* name = "/vsimem/citygml_test.gml";
  auto* bytes = reinterpret_cast<GByte*>(const_cast<char*>(text.data()));
  VSIFCloseL(VSIFileFromMemBuffer(name, bytes, text.size(), FALSE));
  auto result = cityGmlFormat().read(name, options, {});
  VSIUnlink(name);
  return result;
}

Result<CityModel> read2(const std::string& members) {
  return readText(kHead2 + members + "</c:CityModel>");
}
Result<CityModel> read3(const std::string& members) {
  return readText(kHead3 + members + "</CityModel>");
}

std::string building(const std::string& content, const std::string& id = "b1") {
  return "<c:cityObjectMember><b:Building g:id='" + id + "'>" + content +
         "</b:Building></c:cityObjectMember>";
}

std::string ring(const std::string& numbers, const std::string& id = {}) {
  return "<g:LinearRing" + (id.empty() ? "" : " g:id='" + id + "'") + "><g:posList>" + numbers +
         "</g:posList></g:LinearRing>";
}

constexpr const char* kSquare = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 0";

std::string polygon(const std::string& id = {}, const std::string& numbers = kSquare) {
  return "<g:Polygon" + (id.empty() ? "" : " g:id='" + id + "'") + "><g:exterior>" +
         ring(numbers, id.empty() ? "" : id + "_r") + "</g:exterior></g:Polygon>";
}

std::string multi(const std::string& lod, const std::string& members) {
  return "<b:lod" + lod + "MultiSurface><g:MultiSurface>" + members + "</g:MultiSurface></b:lod" + lod +
         "MultiSurface>";
}

std::string member(const std::string& surface) {
  return "<g:surfaceMember>" + surface + "</g:surfaceMember>";
}
std::string link(const std::string& id) {
  return "<g:surfaceMember x:href='#" + id + "'/>";
}

std::string solid(const std::string& lod, const std::string& members) {
  return "<b:lod" + lod + "Solid><g:Solid><g:exterior><g:CompositeSurface>" + members +
         "</g:CompositeSurface></g:exterior></g:Solid></b:lod" + lod + "Solid>";
}

std::string boundary(const std::string& type, const std::string& content) {
  return "<b:boundedBy><b:" + type + ">" + content + "</b:" + type + "></b:boundedBy>";
}

std::vector<Code> codesOf(const Diagnostics& diagnostics) {
  std::vector<Code> codes;
  for (const Diagnostic& d : diagnostics) codes.push_back(d.code);
  return codes;
}

const CityObject& only(const Result<CityModel>& result) {
  return result->buildings.at(0).object;
}

std::vector<Vec3> ringOf(const Geometry& g, std::size_t r) {
  std::vector<Vec3> points;
  for (std::uint32_t i = g.ringStart[r]; i < g.ringStart[r + 1]; ++i)
    points.push_back(g.vertices[g.ringVertices[i]]);
  return points;
}

TEST(CityGml, PrefixesDoNotMatter) {
  const auto model = readText(
      "<CityModel xmlns='http://www.opengis.net/citygml/1.0'><cityObjectMember><Building "
      "xmlns='http://www.opengis.net/citygml/building/1.0' xmlns:gml='urn:else' "
      "xmlns:q='http://www.opengis.net/gml' q:id='u'>"
      "<gml:lod1Solid>not "
      "ours</gml:lod1Solid><lod2MultiSurface><q:MultiSurface><q:surfaceMember><q:Polygon><q:exterior>"
      "<q:LinearRing><q:posList>0 0 0 1 0 0 1 1 0 0 0 "
      "0</q:posList></q:LinearRing></q:exterior></q:Polygon></q:surfaceMember>"
      "</q:MultiSurface></lod2MultiSurface></Building></cityObjectMember></CityModel>");
  ASSERT_TRUE(model);
  EXPECT_EQ(model->sources.at(0).version, "1.0");
  EXPECT_EQ(only(model).id, "u");
  ASSERT_EQ(only(model).geometries.size(), 1U);
  EXPECT_EQ(only(model).geometries[0].lod, "2");
  EXPECT_EQ(only(model).geometries[0].vertices.size(), 3U);
  EXPECT_TRUE(only(model).attributes.empty());
}

TEST(CityGml, SolidTakesTheTypesOfTheSurfacesItLinksToAndRepeatsNone) {
  for (const bool solidFirst : {false, true}) {
    const std::string shell = solid("2", link("roof") + link("wall") + member(polygon("bare")));
    const std::string surfaces =
        boundary("RoofSurface", multi("2", member(polygon("roof")))) +
        boundary("WallSurface", multi("2", member(polygon("wall")) + member(polygon("overhang"))));
    const auto model = read2(building(solidFirst ? shell + surfaces : surfaces + shell));
    ASSERT_TRUE(model);
    EXPECT_TRUE(model.diagnostics.empty());
    ASSERT_EQ(only(model).geometries.size(), 2U);
    const Geometry& shown = only(model).geometries[0];
    EXPECT_EQ(shown.kind, GeometryKind::Solid);
    EXPECT_THAT(shown.shellStart, ElementsAre(0U, 3U));
    EXPECT_THAT(shown.solidStart, ElementsAre(0U, 1U));
    ASSERT_EQ(shown.surfaceCount(), 3U);
    EXPECT_EQ(shown.surfaces[0].type, SurfaceType::Roof);
    EXPECT_EQ(shown.surfaces[1].type, SurfaceType::Wall);
    EXPECT_EQ(shown.surfaces[2].type, SurfaceType::Unknown);
    const Geometry& rest = only(model).geometries[1];
    EXPECT_EQ(rest.kind, GeometryKind::MultiSurface);
    ASSERT_EQ(rest.surfaceCount(), 1U);
    EXPECT_EQ(rest.surfaces[0].type, SurfaceType::Wall);
  }
}

TEST(CityGml, BoundarySurfaceThatLinksToASolidsPolygonGivesItItsType) {
  const auto model =
      read2(building(solid("2", member(polygon("p"))) + boundary("GroundSurface", multi("2", link("p")))));
  ASSERT_TRUE(model);
  ASSERT_EQ(only(model).geometries.size(), 1U);
  EXPECT_EQ(only(model).geometries[0].surfaces.at(0).type, SurfaceType::Ground);
}

TEST(CityGml, OtherLodsKeepTheirSurfaces) {
  const auto model = read2(building(boundary("RoofSurface", multi("2", member(polygon("p")))) +
                                    solid("3", link("p")) + solid("1", member(polygon()))));
  ASSERT_TRUE(model);
  EXPECT_THAT(lodsOf(only(model)), ElementsAre("1", "2", "3"));
}

TEST(CityGml, LinksAcrossObjectsWorkBothWays) {
  const std::string first = building(
      boundary("WallSurface", multi("2", member(polygon("shared")))) + solid("2", link("later")), "a");
  const std::string second = building(
      boundary("RoofSurface", multi("2", member(polygon("later")))) + solid("2", link("shared")), "b");
  const auto model = read2(first + second);
  ASSERT_TRUE(model);
  EXPECT_TRUE(model.diagnostics.empty());
  ASSERT_EQ(model->buildings.size(), 2U);
  const auto solidOf = [&](std::size_t i) { return model->buildings[i].object.geometries.at(0); };
  EXPECT_EQ(solidOf(0).kind, GeometryKind::Solid);
  EXPECT_EQ(solidOf(0).surfaces.at(0).type, SurfaceType::Roof);
  EXPECT_EQ(solidOf(1).surfaces.at(0).type, SurfaceType::Wall);
}

TEST(CityGml, LinksThatLeadNowhereOutsideOrInCirclesAreSaid) {
  const auto nowhere = read2(building(solid("2", link("missing") + member(polygon()))));
  ASSERT_TRUE(nowhere);
  EXPECT_THAT(codesOf(nowhere.diagnostics), ElementsAre(Code::XlinkUnresolved));
  EXPECT_EQ(nowhere.diagnostics[0].object, "b1");
  EXPECT_EQ(only(nowhere).geometries.at(0).surfaceCount(), 1U);

  const auto outside =
      read2(building(solid("2", "<g:surfaceMember x:href='http://a.org/b.gml#c'/>" + member(polygon()))));
  EXPECT_THAT(codesOf(outside.diagnostics), ElementsAre(Code::XlinkOutside));

  const auto circle = read2(building(multi("2", member("<g:CompositeSurface g:id='c'>" + link("c") +
                                                       member(polygon()) + "</g:CompositeSurface>"))));
  ASSERT_TRUE(circle);
  EXPECT_THAT(codesOf(circle.diagnostics), ElementsAre(Code::XlinkCycle));
  EXPECT_EQ(only(circle).geometries.at(0).surfaceCount(),
            2U);  // once by the link, before it closes the circle
}

TEST(CityGml, LinksThatMultiplyAreStopped) {
  std::string text = member("<g:CompositeSurface g:id='c0'>" + member(polygon()) + "</g:CompositeSurface>");
  for (int i = 1; i < 40; ++i) {
    const std::string below = link("c" + std::to_string(i - 1));
    text += member("<g:CompositeSurface g:id='c" + std::to_string(i) + "'>" + below + below +
                   "</g:CompositeSurface>");
  }
  const auto model = read2(building(multi("2", text)));
  ASSERT_TRUE(model);
  EXPECT_THAT(codesOf(model.diagnostics), testing::Contains(Code::CountImplausible));
}

TEST(CityGml, OrientationTurnsRingsRoundButNotForThoseWhoLinkInside) {
  const std::string turned = "<g:OrientableSurface g:id='o' orientation='-'><g:baseSurface>" +
                             polygon("p", "0 0 0 1 0 0 1 1 0 0 0 0") +
                             "</g:baseSurface></g:OrientableSurface>";
  const auto model =
      read2(building(multi("2", member(turned)) + multi("3", link("p")) + multi("4", link("o"))));
  ASSERT_TRUE(model);
  ASSERT_EQ(only(model).geometries.size(), 3U);
  const std::vector<Vec3> forward{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  const std::vector<Vec3> backward{{1, 1, 0}, {1, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(ringOf(only(model).geometries[0], 0), backward);
  EXPECT_EQ(ringOf(only(model).geometries[1], 0), forward);
  EXPECT_EQ(ringOf(only(model).geometries[2], 0), backward);
}

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

TEST(CityGml, PartsInstallationsRoomsAndOpeningsHaveTheirPlaces) {
  const std::string window =
      "<b:opening><b:Window g:id='w'>" + multi("3", member(polygon())) + "</b:Window></b:opening>";
  const auto model = read2(building(
      boundary("WallSurface", multi("3", member(polygon())) + window) +
      "<b:consistsOfBuildingPart><b:BuildingPart g:id='p1'><b:measuredHeight uom='m'>7.5</b:measuredHeight>" +
      solid("1", member(polygon())) +
      "</b:BuildingPart></b:consistsOfBuildingPart>"
      "<b:outerBuildingInstallation><b:BuildingInstallation g:id='i1'>" +
      multi("3", member(polygon())) +
      "</b:BuildingInstallation></b:outerBuildingInstallation>"
      "<b:interiorRoom><b:Room g:id='r1'>" +
      boundary("FloorSurface", multi("4", member(polygon()))) + "</b:Room></b:interiorRoom>"));
  ASSERT_TRUE(model);
  const CityObject& object = only(model);
  ASSERT_EQ(object.geometries.size(), 1U);
  EXPECT_EQ(object.geometries[0].surfaces.at(0).type, SurfaceType::Wall);
  EXPECT_EQ(object.geometries[0].surfaces.at(1).type, SurfaceType::Window);
  ASSERT_EQ(object.children.size(), 3U);
  EXPECT_EQ(object.children[0].type, ObjectType::BuildingPart);
  EXPECT_EQ(object.children[0].attributes.number("measuredHeight"), 7.5);
  EXPECT_EQ(object.children[1].type, ObjectType::BuildingInstallation);
  EXPECT_EQ(object.children[2].type, ObjectType::BuildingRoom);
  EXPECT_EQ(object.children[2].geometries.at(0).surfaces.at(0).type, SurfaceType::Floor);
}

TEST(CityGml, AttributesOfAllKinds) {
  const auto model = read2(building(
      "<g:name>House</g:name><c:creationDate>2014-07-09</"
      "c:creationDate><c:externalReference><c:informationSystem>s</c:informationSystem>"
      "<c:externalObject><c:name>n \"1\"</c:name></c:externalObject></c:externalReference>"
      "<gen:stringAttribute name='s'><gen:value>text</gen:value></gen:stringAttribute>"
      "<gen:intAttribute name='i'><gen:value>-3</gen:value></gen:intAttribute>"
      "<gen:doubleAttribute name='d'><gen:value>0.33</gen:value></gen:doubleAttribute>"
      "<gen:measureAttribute name='m'><gen:value uom='ft'>20.75</gen:value></gen:measureAttribute>"
      "<gen:genericAttributeSet name='set'><gen:intAttribute "
      "name='k'><gen:value>1</gen:value></gen:intAttribute>"
      "<gen:measureAttribute name='l'><gen:value "
      "uom='m2'>2.5</gen:value></gen:measureAttribute></gen:genericAttributeSet>"
      "<b:function>1000</b:function><b:function>2000</b:function><b:yearOfConstruction>1912</"
      "b:yearOfConstruction>"
      "<b:measuredHeight uom='m'>18.5</b:measuredHeight><b:storeysAboveGround>4</b:storeysAboveGround>"
      "<ade:habitants>12</ade:habitants>"));
  ASSERT_TRUE(model);
  const Attributes& a = only(model).attributes;
  EXPECT_EQ(*a.find("name"), AttributeValue("House"));
  EXPECT_EQ(*a.find("s"), AttributeValue("text"));
  EXPECT_EQ(*a.find("i"), AttributeValue(std::int64_t{-3}));
  EXPECT_EQ(*a.find("d"), AttributeValue(0.33));
  EXPECT_EQ(*a.find("m"), AttributeValue(20.75));
  EXPECT_EQ(*a.find("m.uom"), AttributeValue("ft"));
  EXPECT_EQ(*a.find("set"), AttributeValue(JsonText{R"({"k":1,"l":{"value":2.5,"uom":"m2"}})"}));
  EXPECT_EQ(*a.find("function"), AttributeValue(JsonText{R"(["1000","2000"])"}));
  EXPECT_EQ(*a.find("yearOfConstruction"), AttributeValue(std::int64_t{1912}));
  EXPECT_EQ(*a.find("storeysAboveGround"), AttributeValue(std::int64_t{4}));
  EXPECT_EQ(*a.find("measuredHeight"), AttributeValue(18.5));
  EXPECT_EQ(*a.find("externalReference"),
            AttributeValue(JsonText{R"({"informationSystem":"s","externalObject":{"name":"n \"1\""}})"}));
  EXPECT_EQ(a.find("habitants"), nullptr);
}

TEST(CityGml, Version3HeightsAttributesAndBoundaries) {
  const std::string poly = polygon("p");
  const auto model = read3(
      "<cityObjectMember><b:Building g:id='b1'><con:dateOfConstruction>1978-01-01</con:dateOfConstruction>"
      "<con:height><con:Height><con:status>measured</con:status><con:value "
      "uom='m'>17.9</con:value></con:Height></con:height>"
      "<genericAttribute><gen:StringAttribute><gen:name>k</gen:name><gen:value>v</gen:value></"
      "gen:StringAttribute></genericAttribute>"
      "<boundary><con:RoofSurface><lod2MultiSurface><g:MultiSurface>" +
      member(poly) +
      "</g:MultiSurface></lod2MultiSurface>"
      "</con:RoofSurface></boundary><lod2Solid><g:Solid><g:exterior><g:Shell>" +
      link("p") +
      "</g:Shell></g:exterior></g:Solid></lod2Solid>"
      "<b:buildingSubdivision><b:Storey g:id='s1'/></b:buildingSubdivision></b:Building></cityObjectMember>");
  ASSERT_TRUE(model);
  EXPECT_EQ(model->sources[0].version, "3.0");
  const CityObject& object = only(model);
  EXPECT_EQ(object.attributes.number("measuredHeight"), 17.9);
  EXPECT_EQ(object.attributes.number("yearOfConstruction"), 1978);
  EXPECT_EQ(object.attributes.text("k"), "v");
  ASSERT_EQ(object.geometries.size(), 1U);
  EXPECT_EQ(object.geometries[0].surfaces.at(0).type, SurfaceType::Roof);
  EXPECT_EQ(object.children.at(0).type, ObjectType::BuildingStorey);
}

TEST(CityGml, TemplatesArePlacedForEveryObjectThatLinksToThem) {
  const auto furniture = [](const std::string& id, const std::string& geometry, const std::string& at) {
    return "<c:cityObjectMember><f:CityFurniture g:id='" + id +
           "'><f:lod1ImplicitRepresentation><c:ImplicitGeometry>"
           "<c:transformationMatrix>2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1</c:transformationMatrix>" +
           geometry + "<c:referencePoint><g:Point><g:pos>" + at +
           "</g:pos></g:Point></c:referencePoint></c:ImplicitGeometry>"
           "</f:lod1ImplicitRepresentation></f:CityFurniture></c:cityObjectMember>";
  };
  const std::string shape = "<c:relativeGMLGeometry><g:MultiSurface g:id='t'>" + member(polygon()) +
                            "</g:MultiSurface></c:relativeGMLGeometry>";
  const std::string reference = "<c:relativeGMLGeometry x:href='#t'/>";
  for (const bool forward : {false, true}) {
    const auto model = read2(furniture("a", forward ? reference : shape, "10 20 30") +
                             furniture("b", forward ? shape : reference, "100 200 300"));
    ASSERT_TRUE(model);
    EXPECT_TRUE(model.diagnostics.empty());
    ASSERT_EQ(model->others.size(), 2U);
    EXPECT_EQ(model->others[0].geometries.at(0).vertices.at(2), Vec3(12, 22, 30));
    EXPECT_EQ(model->others[1].geometries.at(0).vertices.at(2), Vec3(102, 202, 300));
    EXPECT_EQ(model->others[0].geometries[0].lod, "1");
  }
}

TEST(CityGml, BuildingsInsideGroupsAndUnknownFeaturesAreKept) {
  const auto model = read2(
      "<c:cityObjectMember><grp:CityObjectGroup g:id='g'><grp:groupMember><b:Building "
      "g:id='in'/></grp:groupMember>"
      "<grp:groupMember x:href='#b1'/></grp:CityObjectGroup></c:cityObjectMember>"
      "<c:cityObjectMember><ade:Lamp g:id='lamp'><ade:power>3</ade:power></ade:Lamp></c:cityObjectMember>" +
      building("<ade:more>" + multi("2", member(polygon("hidden"))) + "</ade:more>" +
               "<b:boundedBy><ade:IndustrialRoofSurface>" + multi("2", member(polygon())) +
               "</ade:IndustrialRoofSurface></b:boundedBy>" + solid("2", link("hidden"))));
  ASSERT_TRUE(model);
  ASSERT_EQ(model->buildings.size(), 2U);
  EXPECT_EQ(model->buildings[0].object.id, "in");
  ASSERT_EQ(model->others.size(), 2U);
  EXPECT_EQ(model->others[0].attributes.text("groupMember"), "#b1");
  EXPECT_EQ(model->others[1].id, "lamp");
  const CityObject& object = model->buildings[1].object;
  ASSERT_EQ(object.geometries.size(), 2U);
  EXPECT_EQ(object.geometries[0].kind, GeometryKind::Solid);
  EXPECT_EQ(object.geometries[1].surfaces.at(0).type, SurfaceType::Roof);
}

TEST(CityGml, DuplicateAndMissingIdsAreSaid) {
  const auto model = read2(building("", "same") + building("", "same") +
                           "<c:cityObjectMember><b:Building/></c:cityObjectMember>");
  ASSERT_TRUE(model);
  EXPECT_THAT(codesOf(model.diagnostics), UnorderedElementsAre(Code::DuplicateId, Code::IdMissing));
  EXPECT_EQ(model->buildings.at(2).object.id, "Building@1");
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

std::string appearance2(const std::string& data) {
  return "<a:appearanceMember><a:Appearance><a:theme>t</a:theme><a:surfaceDataMember>" + data +
         "</a:surfaceDataMember></a:Appearance></a:appearanceMember>";
}

TEST(CityGml, AppearancesBeforeAfterAndInsideTheirBuilding) {
  const std::string data =
      appearance2(
          "<a:X3DMaterial g:id='red'><a:diffuseColor>1 0.5 "
          "0</a:diffuseColor><a:transparency>0.25</a:transparency><a:shininess>0.2</a:shininess>"
          "<a:target>#whole</a:target></a:X3DMaterial>") +
      appearance2(
          "<a:ParameterizedTexture><a:imageURI>none.png</a:imageURI><a:wrapMode>wrap</a:wrapMode><a:target "
          "uri='#p'><a:TexCoordList>"
          "<a:textureCoordinates ring='#p_r'>0 0 1 0 1 1 0 1 0 "
          "0</a:textureCoordinates></a:TexCoordList></a:target></a:ParameterizedTexture>");
  const std::string shape = "<b:lod2MultiSurface><g:MultiSurface g:id='whole'>" + member(polygon("p")) +
                            member(polygon("q")) + "</g:MultiSurface></b:lod2MultiSurface>";
  std::string inside = data;
  for (std::size_t at = 0; (at = inside.find("appearanceMember", at)) != std::string::npos;)
    inside.replace(at, 16, "appearance");
  for (const std::string& text : {data + building(shape), building(shape) + data, building(shape + inside)}) {
    const auto model = read2(text);
    ASSERT_TRUE(model);
    EXPECT_THAT(codesOf(model.diagnostics), ElementsAre(Code::TextureMissing));
    ASSERT_EQ(model->materials.size(), 1U);
    EXPECT_EQ(model->materials[0].diffuse, (std::array<float, 3>{1, 0.5, 0}));
    EXPECT_EQ(model->materials[0].transparency, 0.25F);
    EXPECT_EQ(model->materials[0].json, R"({"shininess":0.2})");
    ASSERT_EQ(model->textures.size(), 1U);
    EXPECT_TRUE(model->textures[0].missing);
    EXPECT_EQ(model->textures[0].wrap, "wrap");
    const Geometry& g = only(model).geometries.at(0);
    EXPECT_EQ(g.surfaces[0].material, 0);
    EXPECT_EQ(g.surfaces[1].material, 0);
    EXPECT_EQ(g.surfaces[0].texture, 0);
    EXPECT_EQ(g.surfaces[1].texture, -1);
    ASSERT_EQ(g.textureCoordinates.size(), 8U);
    EXPECT_EQ(g.textureCoordinates[2], Vec2f(1, 1));
    EXPECT_TRUE(std::isnan(g.textureCoordinates[4].x()));
  }
}

TEST(CityGml, TextureCoordinatesThatDoNotFitAndPathsThatLeaveAreRefused) {
  const auto textured = [](const std::string& uri, const std::string& coordinates) {
    return read2(appearance2("<a:ParameterizedTexture><a:imageURI>" + uri +
                             "</a:imageURI><a:target uri='#p'><a:TexCoordList>"
                             "<a:textureCoordinates ring='#p_r'>" +
                             coordinates +
                             "</a:textureCoordinates></a:TexCoordList></a:target></a:ParameterizedTexture>") +
                 building(multi("2", member(polygon("p")))));
  };
  EXPECT_THAT(codesOf(textured("a.png", "0 0 1 0").diagnostics),
              UnorderedElementsAre(Code::TextureMissing, Code::TextureBad));
  EXPECT_THAT(codesOf(textured("a.png", "0 0 1").diagnostics),
              UnorderedElementsAre(Code::TextureMissing, Code::TextureBad));
  for (const auto& [uri, code] :
       {std::pair("../a.png", Code::TextureOutside), std::pair("/etc/passwd", Code::TextureOutside),
        std::pair("x/../../a.png", Code::TextureOutside), std::pair("..\\a.png", Code::TextureOutside),
        std::pair("http://a.org/a.png", Code::TextureMissing)}) {
    const auto model = textured(uri, "0 0 1 0 1 1 0 1 0 0");
    EXPECT_THAT(codesOf(model.diagnostics), ElementsAre(code)) << uri;
    EXPECT_TRUE(model->textures.at(0).missing);
  }
}

TEST(CityGml, TexturedSurfacesKeepTheirShapeAndTheRestIsSaid) {
  const auto model = read2(building(multi(
      "2",
      member("<t:TexturedSurface xmlns:t='http://www.opengis.net/citygml/texturedsurface/1.0' "
             "orientation='+'><g:baseSurface>" +
             polygon() + "</g:baseSurface><t:appearance><t:Material/></t:appearance></t:TexturedSurface>"))));
  ASSERT_TRUE(model);
  EXPECT_THAT(codesOf(model.diagnostics), ElementsAre(Code::AppearanceBad));
  EXPECT_EQ(only(model).geometries.at(0).surfaceCount(), 1U);
}

TEST(CityGml, Version3TexturesNameRingsInElements) {
  const auto model = read3(
      "<appearanceMember><a:Appearance><a:surfaceData><a:ParameterizedTexture><a:imageURI>n.png</"
      "a:imageURI><a:textureParameterization>"
      "<a:TextureAssociation><a:target>#p</"
      "a:target><a:textureParameterization><a:TexCoordList><a:textureCoordinates>0 0 1 0 1 1 0 1 0 0"
      "</a:textureCoordinates><a:ring>#p_r</a:ring></a:TexCoordList></a:textureParameterization></"
      "a:TextureAssociation>"
      "</a:textureParameterization></a:ParameterizedTexture></a:surfaceData></a:Appearance></"
      "appearanceMember>"
      "<cityObjectMember><b:Building g:id='b1'><lod2MultiSurface><g:MultiSurface>" +
      member(polygon("p")) + "</g:MultiSurface></lod2MultiSurface></b:Building></cityObjectMember>");
  ASSERT_TRUE(model);
  const Geometry& g = only(model).geometries.at(0);
  EXPECT_EQ(g.surfaces[0].texture, 0);
  EXPECT_EQ(g.textureCoordinates.at(2), Vec2f(1, 1));
}

TEST(CityGml, TruncatedAnywhereKeepsWhatWasComplete) {
  const std::string whole = kHead2 + building(multi("1", member(polygon())), "a") +
                            building(multi("1", member(polygon())), "b") + "</c:CityModel>";
  const std::size_t firstEnds = whole.find("</b:Building>") + 13;
  const std::size_t secondEnds = whole.rfind("</b:Building>") + 13;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto model = readText(whole.substr(0, length));
    EXPECT_TRUE(hasErrors(model.diagnostics)) << length;
    const std::size_t buildings = model ? model->buildings.size() : 0;
    EXPECT_EQ(buildings, (length >= firstEnds ? 1U : 0U) + (length >= secondEnds ? 1U : 0U)) << length;
    if (buildings > 0) {
      EXPECT_EQ(model.diagnostics[0].code, Code::FileTruncated) << length;
    }
  }
}

TEST(CityGml, HostileAndForeignTextIsRefusedWithItsCode) {
  const auto code = [](const std::string& text) {
    const auto result = readText(text);
    return result.diagnostics.empty() ? Code::Internal : result.diagnostics[0].code;
  };
  EXPECT_EQ(code(""), Code::FileEmpty);
  EXPECT_EQ(code("<a/>"), Code::FormatUnknown);
  EXPECT_EQ(code("not xml"), Code::FileMalformed);
  EXPECT_EQ(code("<!DOCTYPE a [<!ENTITY b 'c'>]><a>&b;</a>"), Code::EntityRefused);
  EXPECT_EQ(code("<!DOCTYPE a SYSTEM 'file:///etc/passwd'><a/>"), Code::EntityRefused);
  EXPECT_EQ(code(kHead2 + building("&lol;") + "</c:CityModel>"), Code::EntityRefused);
  EXPECT_EQ(code("<?xml version='1.0' encoding='utf-8'?><a>\xE4</a>"), Code::EncodingBad);
  EXPECT_EQ(code("<?xml version='1.0' encoding='no-such'?><a/>"), Code::EncodingBad);
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_EQ(code(deep), Code::NestingTooDeep);
}

TEST(CityGml, OneByteEncodingsAreRead) {
  for (const char* encoding : {"ISO-8859-1", "windows-1252", "ISO-8859-15"}) {
    const auto model = readText("<?xml version='1.0' encoding='" + std::string(encoding) + "'?>" + kHead2 +
                                building("<g:name>Stra\xDF"
                                         "e</g:name>") +
                                "</c:CityModel>");
    ASSERT_TRUE(model) << encoding;
    EXPECT_EQ(only(model).attributes.text("name"), "Straße") << encoding;
  }
}

}  // namespace
}  // namespace lodestone
