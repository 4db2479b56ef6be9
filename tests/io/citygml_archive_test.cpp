// CityGML in archives and gzipped, its progress, and stopping it.
#include <algorithm>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include <cpl_vsi.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/io/citygml/citygml.h"
#include "model/io/read_city.h"

namespace lodestone {
namespace {

/// A building of one square of a metre, its corner in (x, y).
std::string document(const std::string& id, const std::string& srs, const std::string& image, int x = 0,
                     int y = 0) {
  std::string square;
  for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}})
    square += std::to_string(x + dx) + " " + std::to_string(y + dy) + " 0 ";
  return "<CityModel xmlns='http://www.opengis.net/citygml/2.0' "
         "xmlns:b='http://www.opengis.net/citygml/building/2.0' "
         "xmlns:g='http://www.opengis.net/gml' xmlns:a='http://www.opengis.net/citygml/appearance/2.0'>"
         "<g:boundedBy><g:Envelope srsName='" +
         srs +
         "'/></g:boundedBy><a:appearanceMember><a:Appearance><a:surfaceDataMember>"
         "<a:ParameterizedTexture><a:imageURI>" +
         image +
         "</a:imageURI><a:target uri='#p'><a:TexCoordList><a:textureCoordinates "
         "ring='#r'>0 0 1 0 1 1 0 "
         "0</a:textureCoordinates></a:TexCoordList></a:target></a:ParameterizedTexture>"
         "</a:surfaceDataMember></a:Appearance></a:appearanceMember><cityObjectMember><b:Building g:id='" +
         id +
         "'>"
         "<b:lod1MultiSurface><g:MultiSurface><g:surfaceMember><g:Polygon g:id='p'><g:exterior><g:LinearRing "
         "g:id='r'><g:posList>" +
         square +
         "</g:posList></g:LinearRing></g:exterior></g:Polygon></g:surfaceMember></g:MultiSurface>"
         "</b:lod1MultiSurface></b:Building></cityObjectMember></CityModel>";
}

bool says(const Diagnostics& diagnostics, Code code) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [&](const Diagnostic& d) { return d.code == code; });
}

class CityGmlArchive : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("lodestone_citygml_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static void write(const std::string& path, const std::string& text) {
    VSILFILE* file = VSIFOpenL(path.c_str(), "wb");
    ASSERT_NE(file, nullptr) << path;
    VSIFWriteL(text.data(), 1, text.size(), file);
    VSIFCloseL(file);
  }
  [[nodiscard]] std::filesystem::path zip(
      const std::vector<std::pair<std::string, std::string>>& members) const {
    const auto path = folder_ / "town.zip";
    const std::string root = "/vsizip/{" + path.string() + "}/";
    VSILFILE* holder = VSIFOpenL(root.c_str(), "wb");  // keeps the archive open for all members
    for (const auto& [name, text] : members) write(root + name, text);
    if (holder) VSIFCloseL(holder);
    return path;
  }
  std::filesystem::path folder_;
};

TEST_F(CityGmlArchive, MembersBecomeOneModelWithTheirOwnTextures) {
  const auto path = zip({{"codes.xml", "<codes/>"},
                         {"udx/a.gml", document("a", "EPSG:25833", "one.png")},
                         {"udx/b.gml", document("b", "EPSG:25833", "two.png")},
                         {"udx/two.png", "a picture"}});
  const auto model = cityGmlFormat().read(path, {}, {});
  ASSERT_TRUE(model);
  ASSERT_EQ(model->buildings.size(), 2U);
  ASSERT_EQ(model->sources.size(), 1U) << "a chain can be made again from the archive";
  EXPECT_EQ(model->sources[0].path, path.string());
  EXPECT_EQ(model->buildings[1].source, 0U);
  EXPECT_EQ(model->crs.source, "EPSG:25833");
  ASSERT_EQ(model->textures.size(), 2U);
  const auto textureOf = [&](std::size_t i) {
    return model->buildings[i].object.geometries.at(0).surfaces.at(0).texture;
  };
  EXPECT_EQ(model->textures.at(static_cast<std::size_t>(textureOf(0))).path, "one.png");
  EXPECT_TRUE(model->textures.at(static_cast<std::size_t>(textureOf(0))).missing);
  EXPECT_TRUE(model->textures.at(static_cast<std::size_t>(textureOf(1))).path.ends_with("}/udx/two.png"));
  EXPECT_FALSE(model->textures.at(static_cast<std::size_t>(textureOf(1))).missing);
  std::vector<Code> codes;
  for (const auto& d : model.diagnostics) codes.push_back(d.code);
  EXPECT_THAT(codes, testing::UnorderedElementsAre(Code::TextureMissing, Code::MemberSkipped));
}

TEST_F(CityGmlArchive, MembersInAnotherSystemAreBroughtIntoTheFirst) {
  const auto path = zip({{"a.gml", document("a", "EPSG:25833", "x.png", 391000, 5820000)},
                         {"b.gml", document("b", "EPSG:25832", "x.png", 798041, 5827863)}});
  const auto model = readCity({path}, {});
  ASSERT_TRUE(model);
  ASSERT_EQ(model->buildings.size(), 2U);
  EXPECT_EQ(model->crs.epsg, 25833);
  const auto cornerOf = [&](std::size_t i) {
    return model->buildings[i].object.geometries.at(0).vertices.at(0);
  };
  EXPECT_LT((cornerOf(0) - cornerOf(1)).norm(), 1) << "one place, written in two systems";
  EXPECT_TRUE(says(model.diagnostics, Code::CrsMixed));
}

TEST_F(CityGmlArchive, SpellingsOfOneSystemAreOne) {
  const auto path = zip({{"a.gml", document("a", "EPSG:25833", "x.png", 391000, 5820000)},
                         {"b.gml", document("b", "urn:ogc:def:crs:EPSG::25833", "x.png", 391000, 5820000)},
                         {"c.gml", document("c", "", "x.png", 391000, 5820000)}});
  const auto model = readCity({path}, {});
  ASSERT_TRUE(model);
  EXPECT_EQ(model->buildings.size(), 3U);
  EXPECT_FALSE(says(model.diagnostics, Code::CrsMixed));
  EXPECT_TRUE(says(model.diagnostics, Code::CrsAssumed)) << "of c.gml";
}

TEST_F(CityGmlArchive, ABrokenMemberIsSaid) {
  const auto path = zip({{"a.gml", document("a", "EPSG:25833", "x.png", 391000, 5820000)},
                         {"b.gml", document("b", "EPSG:25833", "x.png").substr(0, 300)}});
  const auto model = readCity({path}, {});
  ASSERT_TRUE(model);
  EXPECT_EQ(model->buildings.size(), 1U);
  EXPECT_TRUE(hasErrors(model.diagnostics));
  EXPECT_TRUE(says(model.diagnostics, Code::InputReadInPart));
  EXPECT_TRUE(std::any_of(model.diagnostics.begin(), model.diagnostics.end(), [](const Diagnostic& d) {
    return d.severity == Severity::Error && d.place.find("town.zip!b.gml") != std::string::npos;
  }));
}

TEST_F(CityGmlArchive, ArchiveWithoutCityModelsFails) {
  const auto model = cityGmlFormat().read(zip({{"codes.xml", "<codes/>"}}), {}, {});
  EXPECT_FALSE(model);
  EXPECT_TRUE(hasErrors(model.diagnostics));
}

TEST_F(CityGmlArchive, GzippedAndPlainGiveTheSame) {
  const std::string text = document("a", "EPSG:25833", "x.png");
  const auto plain = folder_ / "a.gml";
  const auto packed = folder_ / "b.gml.gz";
  write(plain.string(), text);
  write("/vsigzip/" + packed.string(), text);
  const auto a = cityGmlFormat().read(plain, {}, {});
  const auto b = cityGmlFormat().read(packed, {}, {});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->buildings.at(0).object.id, b->buildings.at(0).object.id);
  EXPECT_EQ(a->buildings[0].object.geometries.at(0).vertices,
            b->buildings[0].object.geometries.at(0).vertices);
}

TEST_F(CityGmlArchive, TexturesElsewhereAreFoundOnlyWhenAllowed) {
  write((folder_ / "image.png").string(), "a picture");
  std::filesystem::create_directories(folder_ / "sub");
  write((folder_ / "sub/a.gml").string(), document("a", "EPSG:25833", "../image.png"));
  const auto refused = cityGmlFormat().read(folder_ / "sub/a.gml", {}, {});
  EXPECT_TRUE(refused->textures.at(0).missing);
  ImportOptions options;
  options.allowOutside = true;
  const auto allowed = cityGmlFormat().read(folder_ / "sub/a.gml", options, {});
  EXPECT_FALSE(allowed->textures.at(0).missing);
  EXPECT_TRUE(allowed.diagnostics.empty());
  // A symbolic link inside the folder does not lead out either.
  std::filesystem::create_symlink(folder_ / "image.png", folder_ / "sub/inside.png");
  write((folder_ / "sub/b.gml").string(), document("b", "EPSG:25833", "inside.png"));
  const auto linked = cityGmlFormat().read(folder_ / "sub/b.gml", {}, {});
  ASSERT_EQ(linked.diagnostics.size(), 1U);
  EXPECT_EQ(linked.diagnostics[0].code, Code::TextureOutside);
}

TEST_F(CityGmlArchive, ReportsProgressAndStopsWhenAsked) {
  const auto path = folder_ / "a.gml";
  write(path.string(), document("a", "EPSG:25833", "x.png"));
  double done = 0;
  (void)cityGmlFormat().read(path, {}, Progress([&](double share, const std::string&) { done = share; }));
  EXPECT_GT(done, 0.5);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)cityGmlFormat().read(path, {}, Progress({}, stop.get_token())), Cancelled);
}

}  // namespace
}  // namespace lodestone
