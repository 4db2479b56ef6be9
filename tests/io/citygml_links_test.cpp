// How surfaces link to each other within and across objects, and what that says of their types.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/citygml_text.h"

namespace lodestone::test {
namespace {

using testing::ElementsAre;

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

}  // namespace
}  // namespace lodestone::test
