// Buildings, what belongs to them, what is known of them, and what stands around them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/citygml_text.h"

namespace lodestone::test {
namespace {

using testing::UnorderedElementsAre;

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

}  // namespace
}  // namespace lodestone::test
