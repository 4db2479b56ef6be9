#include "model/io/citygml/citygml.h"

#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

struct Counts {
  std::size_t buildings = 0, parts = 0, surfaces = 0;
  bool operator==(const Counts&) const = default;
};

Counts countsOf(const CityModel& model) {
  Counts counts;
  counts.buildings = model.buildings.size();
  forEachObjectOf(model, [&](const CityObject& object) {
    if (object.type == ObjectType::BuildingPart) ++counts.parts;
    for (const Geometry& geometry : object.geometries) counts.surfaces += geometry.surfaceCount();
  });
  return counts;
}

/// The files of the issue and what their README counts; `surfaces` are polygons and triangles, less those
/// that the reader leaves out and names, plus those that two solids share.
struct RealFile {
  const char* path;
  Counts counts;
};

class RealCityGml : public testing::TestWithParam<RealFile> {};

TEST_P(RealCityGml, HasTheCountsOfItsReadme) {
  const auto path = test::sharedData(GetParam().path);
  if (path.empty()) GTEST_SKIP() << "shared data not present";
  const auto model = cityGmlFormat().read(path, {}, {});
  ASSERT_TRUE(model);
  const Counts counts = countsOf(*model);
  EXPECT_EQ(counts.buildings, GetParam().counts.buildings);
  EXPECT_EQ(counts.parts, GetParam().counts.parts);
  EXPECT_EQ(counts.surfaces, GetParam().counts.surfaces);
}

INSTANTIATE_TEST_SUITE_P(
    Files, RealCityGml,
    testing::Values(
        RealFile{"A_citygml/berlin_lod2_argis/Berlin1b/3900_5820.gml", {75, 0, 2325}},
        RealFile{"A_citygml/berlin_lod2_argis/Berlin1b/3910_5820.gml", {56, 0, 3031}},
        RealFile{"A_citygml/berlin_lod2_argis/Berlin1b/3920_5820.gml", {6, 0, 133}},
        RealFile{"A_citygml/nrw_lod2/LoD2_32_280_5657_1_NW.gml", {83, 50, 1144}},
        RealFile{"A_citygml/potsdam_berlin_3dcitydb/Potsdam/CityGML/Potsdam_LoD1/Potsdam_LoD1.gml",
                 {97, 0, 1547}},
        RealFile{"A_citygml/libcitygml/berlin_open_data_sample_data.citygml", {61, 0, 1125}},
        RealFile{"A_citygml/plateau_tiles_yuuhayashi/51311568_bldg_6697_op.gml", {225, 0, 1946}},
        RealFile{"A_citygml/plateau_tiles_yuuhayashi/53375768_bldg_6697_op.gml", {329, 0, 3523}},
        RealFile{"A_citygml/citygml4j/lod2_buildings_v3.gml", {100, 0, 700}},
        RealFile{"A_citygml/citygml4j/lod3_building_v2.gml", {1, 0, 3092}},
        RealFile{"A_citygml/zurich_delft_njam/zurich-lod2-citygml1.xml", {4, 6, 61}},
        RealFile{"A_citygml/plateau_builder/gml/13100_tokyo23-ku_2022_citygml_1_3_op/udx/bldg/"
                 "53392633_bldg_6697_2_op.gml",
                 {9, 0, 1083}},
        RealFile{"A_citygml/plateau_gis_converter/nusamai-plateau/tests/data/yokosuka-shi/udx/bldg/"
                 "52397519_bldg_6697_op.gml",
                 {13, 2, 811}},
        RealFile{"A_citygml/plateau_gis_converter/nusamai-plateau/tests/data/yokosuka-shi/udx/dem/"
                 "523965_dem_6697_05_op.gml",
                 {0, 0, 1066}},
        // 14,871 polygons, 25 of them shown a second time by links.
        RealFile{"A_citygml/fzkhaus_all_lods/FZK-Haus-LoD-all-KIT-IAI-KHH-B36-V1.zip", {1, 0, 14896}},
        // 259 and 2279 less the rings of two points.
        RealFile{"A_citygml/ingolstadt_lod3/4018148/4018148.xml", {1, 0, 245}},
        RealFile{"A_citygml/ogc_citygml3_examples/Building/Opera-Lyon_CityGML3.0_LOD2_with_xAL3_FreeText.gml",
                 {1, 0, 2278}},
        RealFile{"F_random3dcity/set1/LOD3_0.gml", {95, 0, 830}},
        RealFile{"F_random3dcity/set1/LOD2_3_F0.gml", {95, 0, 797}},
        RealFile{"F_random3dcity/set1/LOD1_1_F0_H3_solid.gml", {95, 0, 578}},
        RealFile{"A_citygml/ingolstadt_lod3/4018128/4018128.xml", {1, 0, 2309}}));

/// What two encodings of one model must have in common: each object's surfaces by LoD and type, whatever
/// stands first.
std::multiset<std::string> contentOf(const CityModel& model) {
  std::multiset<std::string> content;
  forEachObjectOf(model, [&](const CityObject& object) {
    for (const Geometry& geometry : object.geometries) {
      for (std::size_t s = 0; s < geometry.surfaceCount(); ++s) {
        const std::uint32_t ring = geometry.surfaceStart[s];
        Box3 box;
        for (std::uint32_t i = geometry.ringStart[ring]; i < geometry.ringStart[ring + 1]; ++i) {
          box.add(geometry.vertices[geometry.ringVertices[i]]);
        }
        content.insert(std::string(toString(object.type)) + " " + geometry.lod +
                       (geometry.isSolid() ? " solid " : " surface ") + toString(geometry.surfaces[s].type) +
                       " " + std::to_string(geometry.ringStart[ring + 1] - geometry.ringStart[ring]) + " " +
                       std::to_string(box.min.x()) + " " + std::to_string(box.max.y()) + " " +
                       std::to_string(box.max.z()));
      }
    }
  });
  return content;
}

class CityGmlTwins : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(CityGmlTwins, Versions2And3OfOneModelAgree) {
  const std::string folder = "A_citygml/ogc_citygml3_examples/";
  const auto second = test::sharedData(folder + GetParam().first);
  const auto third = test::sharedData(folder + GetParam().second);
  if (second.empty() || third.empty()) GTEST_SKIP() << "shared data not present";
  const auto a = cityGmlFormat().read(second, {}, {});
  const auto b = cityGmlFormat().read(third, {}, {});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(b->sources.at(0).version, "3.0");
  EXPECT_EQ(a->crs.source, b->crs.source);
  EXPECT_EQ(countsOf(*a), countsOf(*b));
  EXPECT_EQ(contentOf(*a), contentOf(*b));
}

INSTANTIATE_TEST_SUITE_P(
    Ogc, CityGmlTwins,
    testing::Values(
        std::pair{"XLink-examples/1_SimpleBuilding/CityGML_2.gml",
                  "XLink-examples/1_SimpleBuilding/CityGML_3.gml"},
        std::pair{"XLink-examples/2_SimpleBuilding_Roof_Overhangs/CityGML_2.gml",
                  "XLink-examples/2_SimpleBuilding_Roof_Overhangs/CityGML_3.gml"},
        std::pair{"XLink-examples/3_Building_With_Nested_Features/CityGML_2.gml",
                  "XLink-examples/3_Building_With_Nested_Features/CityGML_3.gml"},
        std::pair{"Examples-from-CityGML-2.0/building/CityGMLv2/Building_LOD1-EPSG25832.gml",
                  "Examples-from-CityGML-2.0/building/CityGMLv3/Building_LOD1-EPSG25832.gml"},
        std::pair{"Examples-from-CityGML-2.0/building/CityGMLv2/Building_LOD2-EPSG25832.gml",
                  "Examples-from-CityGML-2.0/building/CityGMLv3/Building_LOD2-EPSG25832.gml"},
        std::pair{"Examples-from-CityGML-2.0/building/CityGMLv2/Building_and_garage_LOD2-EPSG25832.gml",
                  "Examples-from-CityGML-2.0/building/CityGMLv3/Building_and_garage_LOD2-EPSG25832.gml"}));

TEST(RealCityGmlFiles, TexturesOfIngolstadtArePresentAndPlaced) {
  const auto path = test::sharedData("A_citygml/ingolstadt_lod3/4018128/4018128.xml");
  if (path.empty()) GTEST_SKIP() << "shared data not present";
  const auto model = cityGmlFormat().read(path, {}, {});
  ASSERT_TRUE(model);
  ASSERT_EQ(model->textures.size(), 5U);
  for (const Texture& texture : model->textures)
    EXPECT_TRUE(std::filesystem::exists(texture.path)) << texture.path;
  std::size_t textured = 0;
  std::size_t placed = 0;
  for (const Geometry& geometry : model->buildings.at(0).object.geometries) {
    for (std::size_t s = 0; s < geometry.surfaceCount(); ++s) {
      if (geometry.surfaces[s].texture < 0) continue;
      ++textured;
      const std::uint32_t first = geometry.ringStart[geometry.surfaceStart[s]];
      if (std::isfinite(geometry.textureCoordinates.at(first).x())) ++placed;
    }
  }
  EXPECT_GT(textured, 0U);
  EXPECT_EQ(placed, textured);
}

TEST(RealCityGmlFiles, BrokenPlateauTileKeepsItsBuildingsBeforeTheBreak) {
  const auto path = test::sharedData("A_citygml/plateau_tiles_yuuhayashi/51357441_bldg_Issue138-B.gml");
  if (path.empty()) GTEST_SKIP() << "shared data not present";
  const auto model = cityGmlFormat().read(path, {}, {});
  ASSERT_TRUE(model);
  EXPECT_GT(model->buildings.size(), 0U);
  ASSERT_EQ(model.diagnostics.size(), 1U);
  EXPECT_EQ(model.diagnostics[0].code, Code::FileMalformed);
  EXPECT_NE(model.diagnostics[0].place.find(":202"), std::string::npos);
}

}  // namespace
}  // namespace lodestone
