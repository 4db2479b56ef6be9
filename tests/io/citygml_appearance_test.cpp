// Materials and textures, before, after and inside what they cover.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/citygml_text.h"

namespace lodestone::test {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

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

}  // namespace
}  // namespace lodestone::test
